// Reports from results folders written by hand: every figure was worked out on paper.
#include "reports/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <sstream>

#include "base/files.hpp"
#include "base/temporary_folder.hpp"
#include "maps/formats.hpp"
#include "maps/path_file.hpp"

namespace oxturn {
namespace {

namespace fs = std::filesystem;

std::string table(const std::string& name, const Results& results) {
  return built_in_tables().find(name).markdown(results);
}
Written write(const Results& results, const std::string& folder) {
  return write_report(results, built_in_tables(), folder);
}

using testing::HasSubstr;
using testing::Not;

class Folder : public TemporaryFolder {
 public:
  std::string operator/(const std::string& name) const { return file(name); }
  std::string name() const { return path().string(); }
};

using Cells = std::map<std::string, std::string>;

Row row(const std::string& map, const std::string& variant, const std::string& outcome, Cells more = {}) {
  Row r;
  r.cells = {{"schema", "1"},      {"run_id", map + "-" + variant},
             {"attempt", "1"},     {"suite", "hand"},
             {"map", map},         {"map_sha256", "00ff" + map},
             {"planner", variant}, {"variant", variant},
             {"robot", "disc"},    {"repeat", "1"},
             {"outcome", outcome}};
  for (const auto& [k, v] : more) r.cells.set(k, v);
  return r;
}

Results hand_written() {
  Results results;
  results.rows = {
      row("m1", "good", "ok",
          {{"coverage", "1"},
           {"length_ratio", "1.2"},
           {"overlap", "0.1"},
           {"revisits", "0.2"},
           {"turns", "10"},
           {"mission_s", "100"},
           {"plan_wall_s", "0.5"},
           {"plan_cpu_s", "0.4"},
           {"path_95_m", "40"},
           {"mission_95_s", "80"},
           {"path_m", "50"},
           {"clearance_m", "0.01"}}),
      row("m1", "bad", "timeout", {{"reason", "wall time above 20 s"}, {"plan_wall_s", "20"}}),
      row("m2", "good", "ok",
          {{"coverage", "0.995"},
           {"length_ratio", "1.6"},
           {"overlap", "0.3"},
           {"revisits", "0.4"},
           {"turns", "30"},
           {"mission_s", "300"},
           {"plan_cpu_s", "1.4"},
           {"path_95_m", "90"},
           {"mission_95_s", "120"},
           {"plan_wall_s", "1.5"}}),
      row("m2", "bad", "ok",
          {{"coverage", "0.99"}, {"path_95_m", "60"}, {"mission_95_s", "120"}, {"plan_wall_s", "2"}}),
      row("m3", "good", "partial",
          {{"coverage", "0.5"},
           {"length_ratio", "9"},
           {"turns", "20"},
           {"plan_wall_s", "0.7"},
           {"reason", "coverage 0.5000 is below 0.99"}}),
      row("m3", "bad", "invalid", {{"coverage", "0.9"}, {"reason", "leaves | the <map>"}, {"plan_wall_s", "3"}}),
  };
  return results;
}

/// The cells of the table's line that begins with `name`.
std::vector<std::string> cells_of(const std::string& table, const std::string& name) {
  std::istringstream in(table);
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> cells;
    std::string cell;
    for (std::size_t i = 1; i < line.size(); ++i) {
      if (line[i] == '|' && line[i - 1] != '\\') {
        const auto a = cell.find_first_not_of(' ');
        cells.push_back(a == std::string::npos ? "" : cell.substr(a, cell.find_last_not_of(' ') - a + 1));
        cell.clear();
      } else {
        cell += line[i];
      }
    }
    if (!cells.empty() && cells.front() == name) return cells;
  }
  return {};
}

TEST(Comparison, FiguresWorkedOutOnPaper) {
  const std::string text = table("comparison", hand_written());
  EXPECT_EQ(cells_of(text, "good"),
            (std::vector<std::string>{"good", "3", "2", "1", "", "0.5000", "0.8317", "", "2 of 3", "1.25", "1.00",
                                      "0.20", "0.30", "20", "0.90 (0.40 to 1.4)", "0.70"}));
}

// A run that gives nothing counts as nothing; it neither vanishes nor flatters the mean.
TEST(Comparison, FailuresStayInTheDenominator) {
  const std::string text = table("comparison", hand_written());
  EXPECT_EQ(cells_of(text, "bad"),
            (std::vector<std::string>{"bad", "3", "1", "0", "1 invalid, 1 timeout", "0.0000", "0.3300", "", "1 of 3",
                                      "1.00", "1.00", "", "", "", "", "3.0"}));
}

TEST(Comparison, WhatTheHarnessLostIsNotThePlannersCoverage) {
  Results results;
  results.rows = {row("m1", "a", "ok", {{"coverage", "1"}}), row("m2", "a", "infrastructure")};
  const auto cells = cells_of(table("comparison", results), "a");
  ASSERT_GE(cells.size(), 7u);
  EXPECT_EQ(cells[1], "2");
  EXPECT_EQ(cells[4], "1 infrastructure");
  EXPECT_EQ(cells[5], "1.0000");
}

TEST(Comparison, NoRowsIsNothing) { EXPECT_EQ(table("comparison", Results{}), ""); }

Row tied(const std::string& map, const std::string& variant, const std::string& outcome, const std::string& longest,
         const std::string& crossings, const std::string& wound, const std::string& ratio) {
  return row(map, variant, outcome,
             {{"tether_limit_m", "10"},
              {"tether_max_m", longest},
              {"tether_crossings", crossings},
              {"tether_entangled", wound},
              {"tether_sharp_fraction", "0.25"},
              {"length_ratio", ratio}});
}

TEST(Tether, FiguresWorkedOutOnPaper) {
  Results results;
  results.rows = {tied("m1", "a", "ok", "10", "0", "0", "1.2"),
                  tied("m2", "a", "invalid", "12.5", "3", "1", "1.4"),
                  tied("m3", "a", "ok", "10.0000001", "1", "0", "2"),  // within rounding of the limit
                  row("m4", "a", "crash"),
                  tied("m5", "a", "ok", "9", "8", "1", "3"),
                  row("m1", "b", "unsupported")};
  const std::string text = table("tether", results);
  EXPECT_EQ(cells_of(text, "a"),
            (std::vector<std::string>{"a", "5", "4", "1.700", "0.75", "2.50", "2", "0.50", "0.250"}));
  EXPECT_EQ(cells_of(text, "b"), (std::vector<std::string>{"b", "1", "0", "", "", "", "", "", ""}));
  const Folder out;
  write(results, out.name());
  EXPECT_THAT(read_file(out / "report.md"), HasSubstr("## Tether\n\n" + text));
}

TEST(Tether, NoTableWithoutTethers) {
  EXPECT_EQ(table("tether", hand_written()), "");
  const Folder out;
  write(hand_written(), out.name());
  EXPECT_THAT(read_file(out / "report.md"), Not(HasSubstr("## Tether")));
}

TEST(Report, OneTableAMapWithReasons) {
  const Folder out;
  write(hand_written(), out.name());
  const std::string report = read_file(out / "report.md");
  for (const char* map : {"### m1", "### m2", "### m3"}) EXPECT_THAT(report, HasSubstr(map));
  EXPECT_THAT(report, HasSubstr("wall time above 20 s"));
  EXPECT_THAT(report, HasSubstr("leaves \\| the &lt;map>"));
  const std::string page = read_file(out / "gallery.html");
  EXPECT_THAT(page, HasSubstr("leaves | the &lt;map&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("<map>")));
  EXPECT_THAT(page, Not(HasSubstr("<script")));
  EXPECT_THAT(page, Not(HasSubstr("http://")));
}

TEST(Report, NamesCannotBecomeMarkup) {
  Results results;
  results.rows = {row("<img src=x>", "a\"><b>", "ok", {{"coverage", "1"}})};
  const Folder out;
  write(results, out.name());
  const std::string page = read_file(out / "gallery.html");
  EXPECT_THAT(page, Not(HasSubstr("<img src=x>")));
  EXPECT_THAT(page, Not(HasSubstr("<b>")));
  EXPECT_THAT(read_file(out / "report.md"), Not(HasSubstr("<img")));
}

TEST(Report, TwoMapsOfOneNameAreToldApart) {
  Results results;
  results.rows = {row("rooms-1", "a", "ok"),
                  row("rooms-1", "a", "ok", {{"map_sha256", "abcdef0123"}, {"run_id", "2"}})};
  const Folder out;
  write(results, out.name());
  EXPECT_THAT(read_file(out / "report.md"), HasSubstr("### rooms-1 (abcdef01)"));
}

class WithAPicture : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(out_ / "pictures");
    write_file(out_ / "pictures/r1.svg", "<svg/>");
    write_file(out_ / "runs.csv",
               "run_id,suite,map,planner,variant,robot,repeat,outcome,reason,coverage,new_column\n"
               "r1,s,box,a,a,disc,1,ok,,1,7\n"
               "r2,s,box,b,b,disc,1,crash,signal 11,,\n");
    results_ = read_results(out_.name());
  }
  Folder out_;
  Results results_;
};

TEST_F(WithAPicture, APictureForEachPathAndAnEmptyFrameForTheOthers) {
  const Written written = write(results_, out_.name());
  EXPECT_EQ(written.files.size(), 2u);
  const std::string page = read_file(out_ / "gallery.html");
  EXPECT_THAT(page, HasSubstr("src=\"pictures/r1.svg\""));
  EXPECT_THAT(page, HasSubstr("no path"));
  EXPECT_THAT(read_file(out_ / "report.md"), HasSubstr("[a](pictures/r1.svg)"));
}

TEST_F(WithAPicture, ElsewhereThePicturesAreCopiedAndTheBytesAreTheSame) {
  write(results_, out_.name());
  const Folder other;
  EXPECT_EQ(write(results_, other.name()).files.size(), 3u);
  for (const char* name : {"report.md", "gallery.html", "pictures/r1.svg"})
    EXPECT_EQ(read_file(out_ / name), read_file(other / name)) << name;
}

TEST_F(WithAPicture, ARunIdThatLeadsOutOfTheFolderIsRefused) {
  write_file(out_ / "runs.csv",
             "run_id,suite,map,planner,variant,robot,repeat,outcome,reason\n../../x,s,box,a,a,disc,1,ok,\n");
  EXPECT_THAT([&] { read_results(out_.name()); },
              testing::ThrowsMessage<std::invalid_argument>(HasSubstr("'../../x' is not made of letters")));
}

}  // namespace
}  // namespace oxturn
