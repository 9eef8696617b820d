// Pages from rows written by hand: every figure was worked out on paper.
#include "reports/pages/pages.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "bench/suite.hpp"
#include "tests/support/files.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;
using testing::Not;

using Cells = std::map<std::string, std::string>;

Row row(const std::string& suite, const std::string& map, const std::string& planner, const std::string& params,
        const std::string& outcome, const Cells& more) {
  Row r;
  r.cells = {{"suite", suite},
             {"map", map},
             {"map_sha256", map},
             {"robot", "tied"},
             {"repeat", "1"},
             {"planner", planner},
             {"params", params},
             {"outcome", outcome},
             {"variant", params.empty() ? planner : planner + "(" + params + ")"},
             {"plan_wall_s", "123.456"}};
  for (const auto& [k, v] : more) r.cells[k] = v;
  return r;
}

/// The cells of the n-th line of the page whose first cell is `name`.
std::vector<std::string> line(const std::string& page, const std::string& name, std::size_t n) {
  std::istringstream in(page);
  for (std::string text; std::getline(in, text);) {
    std::vector<std::string> cells;
    std::istringstream parts(text);
    for (std::string cell; std::getline(parts, cell, '|');) {
      const auto a = cell.find_first_not_of(' ');
      cells.push_back(a == std::string::npos ? "" : cell.substr(a, cell.find_last_not_of(' ') - a + 1));
    }
    if (cells.size() < 2 || cells[1] != name || n-- > 0) continue;
    cells.erase(cells.begin());
    return cells;
  }
  return {};
}

Cells driven(const std::string& metres, const std::string& coverage, const std::string& target,
             const std::string& longest, const std::string& crossings = "0", const std::string& wound = "0") {
  return {{"path_m", metres},          {"coverage", coverage},    {"target_m2", target},
          {"tether_limit_m", "10"},    {"tether_max_m", longest}, {"tether_crossings", crossings},
          {"tether_entangled", wound}, {"length_ratio", "1.5"}};
}

Results berg() {
  const std::string s = "berg-table-4-1";
  return {"out",
          {row(s, "room", "shnaps-rimon", "", "ok", driven("1250", "0.98", "0.9", "10")),
           row(s, "room", "berg", "", "invalid", driven("100", "0.941", "0.9", "10.5", "2")),
           row(s, "room", "berg", "order=dfs", "partial", driven("110", "0.95", "0.9", "10")),
           row(s, "hall", "shnaps-rimon", "", "ok", driven("3000", "0.97", "0.9", "10")),
           row(s, "hall", "berg", "", "partial", driven("200", "0.93", "0.9", "9")),
           row(s, "hall", "berg", "order=dfs", "crash", {})}};
}

TEST(BergTable, FiguresWorkedOutOnPaper) {
  const std::string page = page_text(find_page("berg-table-4-1"), berg());
  EXPECT_THAT(page, HasSubstr("4743.68"));
  using Line = std::vector<std::string>;
  // planner, rooms, median and least coverage, times berg, length ratio, breaches, invalid
  EXPECT_EQ(line(page, "shnaps-rimon", 0), (Line{"shnaps-rimon", "2", "97.50", "97.00", "13.75", "1.50", "0", "0"}));
  EXPECT_EQ(line(page, "berg", 0), (Line{"berg", "2", "93.55", "93.00", "1.00", "1.50", "1", "1"}));
  EXPECT_EQ(line(page, "berg(order=dfs)", 0),
            (Line{"berg(order=dfs)", "2", "95.00", "95.00", "1.10", "1.50", "0", "0"}));
  // The room's own table: a breach keeps its figures.
  EXPECT_EQ(line(page, "berg", 1), (Line{"berg", "invalid", "94.10", "100.0", "1.00", "1.50", "0.50", "2", ""}));
  EXPECT_EQ(line(page, "shnaps-rimon", 1),
            (Line{"shnaps-rimon", "ok", "98.00", "1250.0", "12.50", "1.50", "", "0", ""}));
}

/// Two leashes on m1, of which the second reaches half of the map; on m2 the leashed run dies.
Results leash() {
  const std::string s = "leash";
  Results results{"out",
                  {row(s, "m1", "zigzag", "ignore_tether=true", "ok", driven("100", "1", "20", "14", "4", "1")),
                   row(s, "m1", "boustrophedon", "ignore_tether=true", "ok", driven("80", "1", "20", "10")),
                   row(s, "m1", "leashed", "planner=zigzag", "ok", driven("90", "0.75", "20", "10")),
                   row(s, "m1", "leashed", "", "ok", driven("88", "1", "20", "9")),
                   row(s, "m1", "boustrophedon", "ignore_tether=true", "ok", driven("80", "1", "10", "25")),
                   row(s, "m1", "leashed", "", "ok", driven("60", "1", "10", "10")),
                   row(s, "m2", "zigzag", "ignore_tether=true;partition=none", "ok", driven("50", "1", "20", "10")),
                   row(s, "m2", "leashed", "planner=zigzag", "error", {{"reason", "no | way"}})}};
  for (const std::size_t i : {1u, 4u}) results.rows[i].cells["path_sha256"] = "same";
  for (const std::size_t i : {4u, 5u}) results.rows[i].cells["robot"] = "short";
  return results;
}

TEST(LeashPage, FiguresWorkedOutOnPaper) {
  const std::string page = page_text(find_page("leash"), leash());
  using Line = std::vector<std::string>;
  // planner, robot, over leash, crossings, entangled, kept, least coverage, price, highest:
  // (90 m / 15 m2) / (100 m / 20 m2) = 1.2; a run without a path covers nothing
  EXPECT_EQ(line(page, "zigzag", 0),
            (Line{"zigzag", "tied", "1 of 2", "2", "1 of 2", "1 of 2", "0.0000", "1.200", "1.200"}));
  EXPECT_EQ(line(page, "boustrophedon", 0),
            (Line{"boustrophedon", "tied", "0 of 1", "0", "0 of 1", "1 of 1", "1.0000", "1.100", "1.100"}));
  // The heedless path sweeps 20 m2, though the short leash reaches 10 of them: (60 / 10) / (80 / 20)
  EXPECT_EQ(line(page, "boustrophedon", 1),
            (Line{"boustrophedon", "short", "1 of 1", "0", "0 of 1", "1 of 1", "1.0000", "1.500", "1.500"}));
  EXPECT_EQ(line(page, "zigzag", 1),
            (Line{"zigzag", "100.0", "1.0000", "4.00", "4", "yes", "90.0", "0.7500", "1.200", ""}));
  EXPECT_EQ(line(page, "boustrophedon", 3),
            (Line{"boustrophedon", "80.0", "1.0000", "15.00", "0", "no", "60.0", "1.0000", "1.500", ""}));
  EXPECT_THAT(page, HasSubstr("error: no \\| way"));
}

Results stc_loops() {
  const std::string s = "stc-loops", slides = "close_loops=false;epsilon=0.05;fill=none";
  Results results{"out", {}};
  const auto add = [&](const std::string& map, const std::string& planner, const std::string& params,
                       const std::string& outcome, const std::string& coverage, const std::string& metres) {
    Cells more{{"coverage", coverage}, {"path_m", metres}, {"length_ratio", "1.5"}};
    more["variant"] = params.empty() ? planner : planner + "[" + params + "]";
    results.rows.push_back(row(s, map, planner, params, outcome, more));
  };
  add("m1", "stc", "", "partial", "0.8", "80");
  add("m1", "stc-loops", slides, "partial", "0.95", "120");
  add("m1", "stc-loops", "", "ok", "0.996", "130");
  add("m2", "stc", "", "infeasible", "", "");
  add("m2", "stc-loops", slides, "partial", "0.97", "20");
  add("m2", "stc-loops", "", "ok", "0.998", "25");
  return results;
}

TEST(StcLoopsPage, FiguresWorkedOutOnPaper) {
  const std::string page = page_text(find_page("stc-loops"), stc_loops());
  using Line = std::vector<std::string>;
  // variant, valid, least coverage, median, 0.99 or more, above stc, length ratio
  EXPECT_EQ(line(page, "stc", 0), (Line{"stc", "1 of 2", "0.8000", "0.8000", "0 of 2", "0 of 2", "1.500"}));
  EXPECT_EQ(line(page, "slides", 0), (Line{"slides", "2 of 2", "0.9500", "0.9600", "0 of 2", "2 of 2", "1.500"}));
  EXPECT_EQ(line(page, "stc-loops", 0), (Line{"stc-loops", "2 of 2", "0.9960", "0.9970", "2 of 2", "2 of 2", "1.500"}));
  EXPECT_EQ(line(page, "m1", 0), (Line{"m1", "0.8000", "0.9500", "", "", "0.9960"}));
  EXPECT_EQ(line(page, "m2", 1), (Line{"m2", "infeasible", "20.0", "", "", "25.0"}));
}

/// On m1 both runs are good, on m2 the one by lidar is invalid, m3 has none with the map.
Results online() {
  const std::string s = "tether-online", lidar = "sensing=lidar";
  const auto run = [](const std::string& metres, const std::string& coverage) {
    Cells cells = driven(metres, coverage, "20", "9");
    cells["coverage_lower"] = coverage;
    return cells;
  };
  Cells bad = run("100", "0.5");
  bad["reason"] = "a | wall";
  return {"out",
          {row(s, "m1", "berg", "order=dfs", "ok", run("100", "1")),
           row(s, "m1", "berg", "order=dfs;" + lidar, "ok", run("130", "0.997")),
           row(s, "m1", "berg", lidar, "ok", run("90", "1")), row(s, "m2", "berg", "order=dfs", "ok", run("100", "1")),
           row(s, "m2", "berg", "order=dfs;" + lidar, "invalid", bad)}};
}

TEST(Pages, TetherOnlinePairsRowsThatDifferInSensingOnly) {
  const std::string page = page_text(find_page("tether-online"), online());
  // planner, valid, least coverage, loss, greatest loss, times as long, at most:
  EXPECT_THAT(line(page, "berg(order=dfs)", 0),
              testing::ElementsAre("berg(order=dfs)", "1 of 2", "0.5000", "0.0030", "0.0030", "1.300", "1.300"));
  EXPECT_THAT(line(page, "berg", 0), testing::ElementsAre("berg", "1 of 1", "1.0000", "", "", "", ""));
  EXPECT_THAT(line(page, "m1", 0),
              testing::ElementsAre("m1", "1.0000", "0.9970", "100.0", "130.0", "1.300", "9.00", "10.00", ""));
  EXPECT_THAT(line(page, "m2", 0)[8], HasSubstr("invalid: a"));
}

TEST(Pages, HoldNoTimesAndSayHowTheyAreMade) {
  for (const auto& [name, results] : {std::pair{"berg-table-4-1", berg()}, std::pair{"leash", leash()},
                                      std::pair{"stc-loops", stc_loops()}, std::pair{"tether-online", online()}}) {
    const std::string page = page_text(find_page(name), results);
    EXPECT_THAT(page, Not(HasSubstr("123.4")));
    EXPECT_THAT(page, HasSubstr(std::string("scripts/pages ") + name));
    Results slower = results;
    for (Row& r : slower.rows) r.cells["plan_wall_s"] = "7";
    slower.folder = "elsewhere";
    EXPECT_EQ(page, page_text(find_page(name), slower));
  }
}

TEST(Pages, EachHasItsSuite) {
  for (const Page& page : pages())
    EXPECT_TRUE(std::filesystem::exists(std::string(OXTURN_SOURCE_DIR) + "/bench/suites/" + page.name + ".toml"));
}

TEST(Pages, RefuseInOneSentence) {
  EXPECT_EQ(complaint([] { find_page("leashes"); }),
            "no page 'leashes'; did you mean 'leash'? There are: berg-table-4-1, leash, stc-loops, tether-online");
  EXPECT_EQ(complaint([] { page_text(find_page("leash"), berg()); }),
            "page 'leash' is made from the results of suite 'leash', but 'out' holds rows of suite 'berg-table-4-1'");
  EXPECT_EQ(complaint([] {
              page_text(find_page("leash"), {"empty", {}});
            }),
            "page 'leash': there are no rows in 'empty'");
}

}  // namespace
}  // namespace oxturn
