#include "bench/results.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <sstream>

#include "base/csv.hpp"
#include "base/files.hpp"
#include "bench/run_lines.hpp"
#include "maps/formats.hpp"
#include "test_planners.hpp"

namespace oxturn {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const Columns& all_columns() {
  static const Columns all = run_columns(built_in_metrics());
  return all;
}

// Typed by hand: a column that is renamed or moved breaks the scripts of users.
TEST(Results, HeaderIsTheContract) {
  EXPECT_EQ(
      csv_header(all_columns()),
      "schema,run_id,attempt,suite,map,map_family,map_sha256,map_params,map_area_m2,map_perimeter_m,map_holes,"
      "map_reflex_vertices,map_narrowest_m,map_area_tools,"
      "planner,planner_family,variant,params,promise,robot,robot_radius_m,tool_width_m,problem_sha256,seed,repeat,"
      "outcome,reason,exit_code,signal,"
      "coverage,coverage_lower,coverage_upper,coverage_of_free,target_m2,"
      "path_m,work_m,transit_m,length_ratio,bound_m,bound_kind,gap,overlap,revisits,promise_coverage,"
      "path_90_m,path_95_m,path_99_m,mission_90_s,mission_95_s,mission_99_s,missed_pieces,missed_largest_m2,"
      "turns,turn_rad,curvature_max_per_m,curvature_violations,cusps,clearance_m,mission_s,"
      "tether_limit_m,tether_max_m,tether_bends_max,tether_angle_min_rad,tether_angle_mean_rad,"
      "tether_sharp_fraction,tether_crossings,tether_entangled,"
      "stroke_share,stroke_error_m,fill_share,fill_share_reachable,spill_m2,tool_up_m,over_finished_m,"
      "work_over_finished_m,tangent_breaks,"
      "plan_wall_s,plan_cpu_s,peak_rss_bytes,score_s,load,path_sha256,path_file\n");
}

/// The column names in the first cells of the table below a heading of docs/formats.md, with the unit.
std::vector<std::string> columns_in_page(const std::string& heading) {
  std::istringstream page(read_file(OXTURN_SOURCE_DIR "/docs/formats.md"));
  std::vector<std::string> columns;
  bool found = false;
  for (std::string line; std::getline(page, line);) {
    if (line.starts_with("#")) found = line == heading;
    if (!found || !line.starts_with("| `")) continue;
    const std::size_t end = line.find(" | ");
    const std::size_t unit = end + 3;
    for (std::size_t at = line.find('`'); at < end; at = line.find('`', line.find('`', at + 1) + 1))
      columns.push_back(line.substr(at + 1, line.find('`', at + 1) - at - 1) + " " +
                        line.substr(unit, line.find_first_of(" |", unit) - unit));
  }
  return columns;
}

TEST(Results, ThePageListsEveryColumn) {
  std::vector<std::string> columns;
  for (const Column& c : all_columns()) columns.push_back(c.name + " " + c.unit);
  EXPECT_EQ(columns_in_page("### `runs.csv`"), columns);
  std::string trace;
  for (const std::string& column : columns_in_page("### `trace.csv`"))
    trace += (trace.empty() ? "" : ",") + column.substr(0, column.find(' '));
  EXPECT_EQ(trace + "\n", kTraceHeader);
}

TEST(Results, EveryColumnExplainsItself) {
  for (const Column& c : all_columns()) {
    EXPECT_FALSE(c.type.empty()) << c.name;
    EXPECT_FALSE(c.help.empty()) << c.name;
  }
}

TEST(Results, OutcomesReadBack) {
  for (int i = 0; i <= static_cast<int>(Outcome::infrastructure); ++i) {
    const auto outcome = static_cast<Outcome>(i);
    EXPECT_EQ(outcome_from(to_text(outcome)), outcome);
  }
  EXPECT_FALSE(outcome_from("fine"));
}

TEST(Results, CsvRoundTrip) {
  const std::vector<std::string> hostile{"",           "plain",  "a,b",  "\"",       "\"\"",     "say \"hi\", twice",
                                         "two\nlines", "cr\rcr", "\r\n", " spaced ", "\xC3\xA9", ",",
                                         "\n"};
  for (const std::string& a : hostile) {
    for (const std::string& b : hostile) {
      Row row;
      row.cells = {{"run_id", "x"}, {"reason", a}, {"path_file", b}, {"outcome", "ok"}};
      const auto lines =
          parse_csv(csv_header(all_columns()) + csv_line(row, all_columns()) + csv_line(row, all_columns()), "t");
      ASSERT_EQ(lines.size(), 3u);
      for (int k : {1, 2}) {
        ASSERT_EQ(lines[k].size(), all_columns().size());
        for (std::size_t i = 0; i < all_columns().size(); ++i) EXPECT_EQ(lines[k][i], row.get(all_columns()[i].name));
      }
    }
  }
}

TEST(Results, CsvByHand) {
  using Lines = std::vector<std::vector<std::string>>;
  EXPECT_EQ(parse_csv("a,b\r\n1,\r\n", "t"), (Lines{{"a", "b"}, {"1", ""}}));
  EXPECT_EQ(parse_csv("\"x\"\"y\",\"\"", "t"), (Lines{{"x\"y", ""}}));
  EXPECT_EQ(parse_csv("", "t"), Lines{});
  EXPECT_THAT([] { parse_csv("a\n\"b\n\n", "f.csv"); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("f.csv:2: a quote is never closed")));
  EXPECT_THAT([] { parse_csv("a\nb\"c\n", "f.csv"); }, ThrowsMessage<std::invalid_argument>(HasSubstr("f.csv:2:")));
  EXPECT_THAT([] { parse_csv("\"b\"c\n", "f.csv"); }, ThrowsMessage<std::invalid_argument>(HasSubstr("f.csv:1:")));
}

TEST(Results, RowKnowsItsColumns) {
  Row row;
  row.cells.set("path_m", "2.5");
  row.cells.set("turns", "many");
  EXPECT_EQ(row.number("path_m"), 2.5);
  EXPECT_EQ(row.number("overlap"), std::nullopt);
  EXPECT_EQ(row.get("no such column"), "");
  EXPECT_THROW(row.number("turns"), std::invalid_argument);
  EXPECT_THROW(row.outcome(), std::invalid_argument);
}

TEST(Results, TheLastAttemptReplacesTheFirst) {
  const testing::Folder folder;
  std::string text = csv_header(all_columns());
  const auto add = [&](const char* id, const char* attempt, const char* outcome) {
    Row row;
    row.cells = {{"run_id", id}, {"attempt", attempt}, {"outcome", outcome}};
    text += csv_line(row, all_columns());
  };
  add("a", "1", "cancelled");
  add("b", "1", "ok");
  add("a", "2", "ok");
  write_file(folder.file("runs.csv"), text);
  const Results results = read_results(folder.path());
  ASSERT_EQ(results.rows.size(), 2u);
  EXPECT_EQ(results.rows[0].get("run_id"), "a");
  EXPECT_EQ(results.rows[0].outcome(), Outcome::ok);
}

// A report copies what is a picture of the folder, nothing from elsewhere.
TEST(Results, PicturesOutsideOfTheFolderAreNone) {
  const testing::Folder folder;
  std::filesystem::create_directories(folder.file("out/pictures"));
  Row row;
  std::string text = csv_header(all_columns());
  for (const char* id : {"inside", "linked", "missing"}) {
    row.cells = {{"run_id", id}, {"outcome", "ok"}};
    text += csv_line(row, all_columns());
  }
  write_file(folder.file("out/runs.csv"), text);
  write_file(folder.file("out/pictures/inside.svg"), "<svg/>");
  write_file(folder.file("secret"), "secret");
  std::filesystem::create_symlink(folder.file("secret"), folder.file("out/pictures/linked.svg"));
  using Pictures = std::map<std::string, std::string>;
  EXPECT_EQ(read_results(folder.file("out")).pictures, (Pictures{{"inside", "pictures/inside.svg"}}));
}

TEST(Results, BadFoldersAreOneSentence) {
  const testing::Folder folder;
  const auto reading = [&] { read_results(folder.path()); };
  EXPECT_THAT([] { read_results("/nowhere"); }, ThrowsMessage<std::invalid_argument>(HasSubstr("no such folder")));
  EXPECT_THAT(reading, ThrowsMessage<std::invalid_argument>(HasSubstr("no runs.csv in")));
  write_file(folder.file("runs.csv"), "a,b\n");
  EXPECT_THAT(reading, ThrowsMessage<std::invalid_argument>(HasSubstr("there is no column 'run_id'")));
  write_file(folder.file("runs.csv"), csv_header(all_columns()) + "1,2\n");
  EXPECT_THAT(reading, ThrowsMessage<std::invalid_argument>(HasSubstr("row 1 has 2 cells")));
}

}  // namespace
}  // namespace oxturn
