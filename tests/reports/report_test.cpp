// Reports from results folders written by hand: every figure was worked out on paper.
#include "reports/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <filesystem>
#include <sstream>

#include "maps/formats.hpp"
#include "base/files.hpp"
#include "maps/path_file.hpp"

namespace oxturn {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "oxturn-reports-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::string name() const { return path_.string(); }

 private:
  fs::path path_;
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
  for (const auto& [k, v] : more) r.cells[k] = v;
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
           {"plan_wall_s", "1.5"}}),
      row("m2", "bad", "ok", {{"coverage", "0.99"}, {"length_ratio", "2"}, {"plan_wall_s", "2"}}),
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
  const std::string table = comparison_table(hand_written());
  EXPECT_EQ(cells_of(table, "good"), (std::vector<std::string>{"good", "3", "2", "1", "", "0.5000", "0.8317", "1.600",
                                                               "0.200", "0.300", "20", "200", "0.700"}));
}

// A run that gives nothing counts as nothing; it neither vanishes nor flatters the mean.
TEST(Comparison, FailuresStayInTheDenominator) {
  const std::string table = comparison_table(hand_written());
  EXPECT_EQ(cells_of(table, "bad"), (std::vector<std::string>{"bad", "3", "1", "0", "1 invalid, 1 timeout", "0.0000",
                                                              "0.3300", "2.000", "", "", "", "", "3.000"}));
}

TEST(Comparison, WhatTheHarnessLostIsNotThePlannersCoverage) {
  Results results;
  results.rows = {row("m1", "a", "ok", {{"coverage", "1"}}), row("m2", "a", "infrastructure")};
  const auto cells = cells_of(comparison_table(results), "a");
  ASSERT_GE(cells.size(), 7u);
  EXPECT_EQ(cells[1], "2");
  EXPECT_EQ(cells[4], "1 infrastructure");
  EXPECT_EQ(cells[5], "1.0000");
}

TEST(Comparison, NoRowsIsAHeadAlone) { EXPECT_THAT(comparison_table({}), HasSubstr("length_ratio")); }

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
  const std::string table = tether_table(results);
  EXPECT_EQ(cells_of(table, "a"),
            (std::vector<std::string>{"a", "5", "4", "1.700", "0.75", "2.50", "2", "0.50", "0.250"}));
  EXPECT_EQ(cells_of(table, "b"), (std::vector<std::string>{"b", "1", "0", "", "", "", "", "", ""}));
  const Folder out;
  write_report(results, out.name());
  EXPECT_THAT(read_file(out / "report.md"), HasSubstr("## Tether\n\n" + table));
}

TEST(Tether, NoTableWithoutTethers) {
  EXPECT_EQ(tether_table(hand_written()), "");
  const Folder out;
  write_report(hand_written(), out.name());
  EXPECT_THAT(read_file(out / "report.md"), Not(HasSubstr("## Tether")));
}

TEST(Report, OneTableAMapWithReasons) {
  const Folder out;
  write_report(hand_written(), out.name());
  const std::string report = read_file(out / "report.md");
  for (const char* map : {"## m1", "## m2", "## m3"}) EXPECT_THAT(report, HasSubstr(map));
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
  write_report(results, out.name());
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
  write_report(results, out.name());
  EXPECT_THAT(read_file(out / "report.md"), HasSubstr("## rooms-1 (abcdef01)"));
}

class WithAPath : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(out_ / "paths");
    fs::create_directories(out_ / "maps");
    MapFile map;
    map.map = {"box", box_region({0, 0}, {4, 2}), "file", "hand"};
    map.start = Point(0.5, 0.5);
    map.robot = Robot{};
    write_file(out_ / "maps/p.geojson", to_geojson(map));
    PathBuilder builder({0.5, 0.5});
    builder.drive({3.5, 0.5}, true);
    builder.drive({3.5, 1.5}, false);
    std::string text = to_geojson(builder.take());
    text.insert(text.find('{') + 1, "\"problem\":\"maps/p.geojson\",");
    write_file(out_ / "paths/r1.geojson", text);
    results_.folder = out_.name();
    results_.rows = {row("box", "a", "ok", {{"run_id", "r1"}, {"path_file", "paths/r1.geojson"}, {"coverage", "1"}}),
                     row("box", "b", "crash", {{"run_id", "r2"}, {"reason", "signal 11"}})};
  }
  Folder out_;
  Results results_;
};

TEST_F(WithAPath, APictureForEachPathAndAnEmptyPlaceForTheOthers) {
  const Written written = write_report(results_, out_.name());
  EXPECT_EQ(written.files.size(), 3u);
  EXPECT_TRUE(fs::exists(out_ / "gallery/r1.svg"));
  EXPECT_FALSE(fs::exists(out_ / "gallery/r2.svg"));
  const std::string page = read_file(out_ / "gallery.html");
  EXPECT_THAT(page, HasSubstr("src=\"gallery/r1.svg\""));
  EXPECT_THAT(page, HasSubstr("no path"));
  EXPECT_THAT(read_file(out_ / "report.md"), HasSubstr("[a](gallery/r1.svg)"));
}

TEST_F(WithAPath, TracesAreDrawn) {
  fs::create_directories(out_ / "traces");
  write_file(out_ / "traces/r1.json", R"([{"name":"cells","lines":[[[1,0],[1,2]]]}])");
  write_report(results_, out_.name());
  EXPECT_THAT(read_file(out_ / "gallery/r1.svg"), HasSubstr("<g id=\"cells\""));
}

TEST_F(WithAPath, SameResultsSameBytes) {
  write_report(results_, out_.name());
  const Folder other;
  write_report(results_, other.name());
  for (const char* name : {"report.md", "gallery.html", "gallery/r1.svg"})
    EXPECT_EQ(read_file(out_ / name), read_file(other / name)) << name;
}

TEST_F(WithAPath, APathWithoutItsProblemIsOneSentence) {
  write_file(out_ / "paths/r1.geojson", to_geojson(Path{{{true, {{0.5, 0.5}, {1, 1}}}}}));
  EXPECT_THAT([&] { write_report(results_, out_.name()); },
              testing::ThrowsMessage<std::invalid_argument>(HasSubstr("no member 'problem'")));
}

}  // namespace
}  // namespace oxturn
