// The commands as their users type them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "bench/results.hpp"
#include "maps/formats.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/maps.hpp"

namespace oxturn {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Json = nlohmann::json;

TEST(Program, HelpHasExamplesForEveryCommand) {
  EXPECT_EQ(oxturn("help").out, oxturn("--help").out);
  EXPECT_EQ(oxturn("help plan").out, oxturn("plan --help").out);
  EXPECT_EQ(oxturn("help plam").code, 2);
  EXPECT_EQ(oxturn("--help").code, 0);
  for (const std::string command : {"list", "map", "plan", "draw", "score", "run", "report", "rescore", "completion"}) {
    const Said said = oxturn(command + " --help");
    EXPECT_EQ(said.code, 0) << command;
    EXPECT_THAT(said.out, HasSubstr("oxturn " + command + " ")) << command;
    EXPECT_THAT(said.out, testing::Not(HasSubstr("{"))) << "no marks of the option parser";
    EXPECT_EQ(said.err, "");
  }
}

TEST(Program, SaysItsVersion) {
  const Said said = oxturn("--version");
  EXPECT_EQ(oxturn("-V").out, said.out);
  EXPECT_EQ(said.code, 0);
  EXPECT_THAT(said.out, StartsWith("oxturn 0."));
}

TEST(List, JsonParsesAndAgreesWithTheText) {
  for (const std::string what : {"planners", "maps", "formats", "metrics", "robot", "suites", "tables", "columns"}) {
    const Said text = oxturn("list " + what), json = oxturn("list " + what + " --json");
    ASSERT_EQ(json.code, 0) << json.err;
    const Json all = Json::parse(json.out);
    ASSERT_TRUE(all.is_array());
    EXPECT_FALSE(all.empty()) << what;
    for (const Json& one : all) EXPECT_THAT(text.out, HasSubstr(one.at("name").get<std::string>())) << what;
  }
}

TEST(List, OnlyWhatIsNamed) {
  const Json all = Json::parse(oxturn("list planners --json").out);
  for (const std::string command : {"list planners zigzag stc", "list planners zigzag stc --json"}) {
    const Said said = oxturn(command);
    EXPECT_EQ(said.code, 0) << said.err;
    EXPECT_THAT(said.out, AllOf(HasSubstr("zigzag"), HasSubstr("cell_size"), Not(HasSubstr("boustrophedon"))));
  }
  const Json some = Json::parse(oxturn("list planners zigzag stc --json").out);
  ASSERT_EQ(some.size(), 2u);
  EXPECT_EQ(some[0].at("name"), "zigzag");  // in the order asked for
  for (const Json& one : some) EXPECT_NE(std::ranges::find(all, one), all.end());
  EXPECT_THAT(oxturn("list columns coverage").out, StartsWith("coverage "));
}

TEST(List, PlannersHaveCitationsAndParameters) {
  for (const Json& planner : Json::parse(oxturn("list planners --json").out)) {
    EXPECT_NE(planner.at("citation"), "") << planner["name"];
    EXPECT_NE(planner.at("guarantee"), "") << planner["name"];
    for (const Json& p : planner.at("parameters")) EXPECT_NE(p.at("help"), "") << p["name"];
  }
}

TEST(MapCommand, SameSeedSameBytesOtherSeedOthers) {
  const Folder out;
  for (const std::string name : {"a", "b"})
    ASSERT_EQ(oxturn("map rooms --seed 7 -o " + (out / (name + ".geojson"))).code, 0);
  ASSERT_EQ(oxturn("map rooms --seed 8 -o " + (out / "c.geojson")).code, 0);
  EXPECT_EQ(content(out / "a.geojson"), content(out / "b.geojson"));
  EXPECT_NE(content(out / "a.geojson"), content(out / "c.geojson"));
}

TEST(MapCommand, ConvertsWithoutChangingTheMap) {
  const Folder out;
  ASSERT_EQ(oxturn("map clutter --seed 3 -o " + (out / "a.geojson")).code, 0);
  ASSERT_EQ(oxturn("map " + (out / "a.geojson") + " -o " + (out / "b.geojson")).code, 0);
  EXPECT_EQ(content_hash(read_map(out / "a.geojson").map), content_hash(read_map(out / "b.geojson").map));
  ASSERT_EQ(oxturn("map " + (out / "a.geojson") + " -o " + (out / "a.svg")).code, 0);
  EXPECT_THAT(content(out / "a.svg"), StartsWith("<svg "));
}

TEST(MapCommand, ReadsAPlainImageWithAScale) {
  const Folder out;
  // 4 x 3 pixels, white but for one black: 11 cells of half a metre.
  out.write("m.pgm", "P2\n4 3\n255\n255 255 255 255\n255 0 255 255\n255 255 255 255\n");
  const Said said = oxturn("map " + (out / "m.pgm") + " --scale 0.5 -o " + (out / "m.geojson"));
  ASSERT_EQ(said.code, 0) << said.err;
  EXPECT_NEAR(area(read_map(out / "m.geojson").map.free), 11 * 0.25, 1e-12);
}

class Planned : public testing::Test {
 protected:
  Folder out;
};

TEST_F(Planned, PathScoresTheSameAgain) {
  const std::string problem = " rooms:2 --radius 0.2 --tool-width 0.4";
  const Said plan =
      oxturn("plan boustrophedon" + problem + " --json -o " + (out / "p.geojson") + " --svg " + (out / "p.svg"));
  ASSERT_EQ(plan.code, 0) << plan.err;
  const Said score = oxturn("score " + (out / "p.geojson") + problem + " --json");
  ASSERT_EQ(score.code, 0) << score.err;
  const Json a = Json::parse(plan.out);
  Json b = Json::parse(score.out);
  b["metrics"]["promise_coverage"] = a["metrics"]["promise_coverage"];  // a path does not tell who planned it
  EXPECT_EQ(a["outcome"], "ok") << a["reason"];
  EXPECT_EQ(a["metrics"], b["metrics"]);
  EXPECT_GE(a["metrics"]["coverage_lower"].get<double>(), 0.99);
  EXPECT_GE(a["metrics"]["length_ratio"].get<double>(), 1.0);
  EXPECT_THAT(content(out / "p.svg"), StartsWith("<svg "));
}

TEST_F(Planned, SaysWhatItChose) {
  const Said said = oxturn("plan stc rectangle");
  ASSERT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.err, HasSubstr("robot: radius 0.2 m, tool width 0.4 m"));
  EXPECT_THAT(said.err, HasSubstr("start: "));
  EXPECT_THAT(said.out, HasSubstr("coverage_lower"));
}

TEST_F(Planned, RobotAndStartOfTheFileAreUsed) {
  const std::string file = out.write(
      "box.geojson",
      R"({"type":"Feature","properties":{"name":"box","robot":{"radius":0.3,"tool_width":0.5},"start":[1,1]},)"
      R"("geometry":{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,3],[0,3],[0,0]]]}})");
  const Said said = oxturn("plan zigzag " + file + " --json");
  ASSERT_EQ(said.code, 0) << said.err;
  EXPECT_EQ(said.err, "");
  const Json json = Json::parse(said.out);
  EXPECT_EQ(json["robot"]["radius"], 0.3);
  EXPECT_EQ(json["start"], Json({1.0, 1.0}));
  const Json other = Json::parse(oxturn("plan zigzag " + file + " --json --start 3,2 --robot radius=0.1").out);
  EXPECT_EQ(other["robot"]["radius"], 0.1);
  EXPECT_EQ(other["robot"]["tool_width"], 0.5);
  EXPECT_EQ(other["start"], Json({3.0, 2.0}));
}

TEST_F(Planned, StartAndAnchorMayBeNames) {
  const std::string file =
      out.write("box.geojson", R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[4,3],[0,3],[0,0]]]})");
  const Said said = oxturn("plan zigzag " + file + " --json --start corner --anchor wall");
  ASSERT_EQ(said.code, 0) << said.err;
  const Json start = Json::parse(said.out).at("start");
  EXPECT_NEAR(start.at(0).get<double>(), 0.204, 1e-3);
  EXPECT_NEAR(start.at(1).get<double>(), 0.204, 1e-3);
  const Said bad = oxturn("plan zigzag " + file + " --anchor ceiling");
  EXPECT_EQ(bad.code, 2);
  EXPECT_THAT(bad.err, HasSubstr("--anchor is 'ceiling', expected X,Y: two finite numbers in metres, or one of: start, "
                                 "wall, corner"));
}

TEST_F(Planned, NegativeStartIsANumberNotAnOption) {
  const std::string file =
      out.write("box.geojson", R"({"type":"Polygon","coordinates":[[[-4,-3],[0,-3],[0,0],[-4,0],[-4,-3]]]})");
  EXPECT_EQ(oxturn("plan zigzag " + file + " --start -1,-1").code, 0);
}

TEST_F(Planned, APathThroughAWallIsInvalidAndExitsWith1) {
  const std::string map = out.write(
      "ring.geojson",
      R"({"type":"Polygon","coordinates":[[[0,0],[6,0],[6,6],[0,6],[0,0]],[[2,2],[2,4],[4,4],[4,2],[2,2]]]})");
  const std::string path =
      out.write("p.geojson", R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"tool":true},)"
                             R"("geometry":{"type":"LineString","coordinates":[[1,3],[5,3]]}}]})");
  const Said said = oxturn("score " + path + " " + map + " --start 1,3 --radius 0.2 --tool-width 0.4");
  EXPECT_EQ(said.code, 1);
  EXPECT_THAT(said.err, HasSubstr("invalid: "));
  EXPECT_THAT(said.out, HasSubstr("outcome"));
}

TEST_F(Planned, TooLittleTimeIsATimeout) {
  const Said said = oxturn("plan boustrophedon clutter:1 --wall 0.0001");
  EXPECT_EQ(said.code, 1);
  EXPECT_THAT(said.err, HasSubstr("timeout"));
}

TEST_F(Planned, RunGivesRowsTableAndPictures) {
  const std::string suite = out.write(
      "s.toml",
      "schema = 1\nname = \"s\"\n[robots.disc]\nradius = 0.2\ntool_width = 0.4\n[[maps]]\ngenerator = \"rectangle\"\n"
      "seeds = [1, 2]\n[[planners]]\nname = \"stc\"\n[[planners]]\nname = \"zigzag\"\n");
  const Said said = oxturn("run " + suite + " -o " + (out / "r") + " -j 2");
  ASSERT_EQ(said.code, 0) << said.err;
  EXPECT_THAT(said.out, HasSubstr("| zigzag"));
  for (const std::string name : {"runs.csv", "columns.json", "session.json", "report.md", "gallery.html"})
    EXPECT_TRUE(std::filesystem::exists(out / ("r/" + name))) << name;
  const std::string csv = content(out / "r/runs.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 * 2);
  std::size_t pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(out / "r/pictures"))
    pictures += entry.path().extension() == ".svg";
  EXPECT_EQ(pictures, 4u);
  // Again into the same folder: refused, in one line; as a resumption it has nothing to do.
  const Said again = oxturn("run " + suite + " -q -o " + (out / "r"));
  EXPECT_EQ(again.code, 2);
  EXPECT_EQ(oxturn("run " + suite + " -q --resume -o " + (out / "r")).code, 0);
  EXPECT_EQ(content(out / "r/runs.csv"), csv);
  // The report alone, elsewhere.
  ASSERT_EQ(oxturn("report " + (out / "r") + " -o " + (out / "elsewhere")).code, 0);
  EXPECT_EQ(content(out / "elsewhere/report.md"), content(out / "r/report.md"));
}

TEST_F(Planned, PlanAndRunGiveTheSameFiguresAndPicture) {
  const std::string suite = out.write(
      "s.toml",
      "schema = 1\nname = \"s\"\n[robots.disc]\nradius = 0.2\ntool_width = 0.4\n[[maps]]\ngenerator = \"rooms\"\n"
      "seeds = [7]\n[[planners]]\nname = \"stc\"\n[[planners]]\nname = \"zigzag\"\n[[planners]]\nname = "
      "\"spiral-out\"\n");
  ASSERT_EQ(oxturn("run " + suite + " -q -o " + (out / "r")).code, 0);
  const Results results = read_results(out / "r");
  ASSERT_EQ(results.rows.size(), 3u);
  std::string promises;
  for (const Row& row : results.rows) {
    SCOPED_TRACE(row.get("planner"));
    const Said said =
        oxturn("plan " + row.get("planner") + " rooms:7 --robot radius=0.2,tool_width=0.4 --json --seed " +
               row.get("seed") + " --svg " + (out / "p.svg"));
    ASSERT_EQ(said.code, 0) << said.err;
    const Json json = Json::parse(said.out);
    promises += json.at("promise").get<std::string>() + " ";
    EXPECT_EQ(json.at("promise"), row.get("promise"));
    for (const auto& [name, value] : json.at("metrics").items())
      EXPECT_EQ(value.is_null() ? "" : to_decimal(value.get<double>()), row.get(name)) << name;
    EXPECT_EQ(json.at("metrics").at("promise_coverage").is_null(), row.get("promise") == "nothing");
    EXPECT_EQ(content(out / "p.svg"), content(out / ("r/pictures/" + row.get("run_id") + ".svg")));
    EXPECT_EQ(content(out / "p.svg").find("id=\"missed\"") != std::string::npos, row.get("missed_pieces") != "0");
  }
  EXPECT_EQ(promises, "cells target nothing ");
  EXPECT_NE(results.rows.front().get("missed_pieces"), "0");
}

TEST_F(Planned, ThePageHasTheTracesThePictureOnlyIfAskedFor) {
  const std::string files = " --viewer " + (out / "p.html") + " --svg " + (out / "p.svg");
  ASSERT_EQ(oxturn("plan stc rectangle" + files).code, 0);
  EXPECT_THAT(content(out / "p.html"), HasSubstr("\"traces\":[{\"name\":\"tree\""));
  EXPECT_THAT(content(out / "p.svg"), testing::Not(HasSubstr("id=\"tree\"")));
  ASSERT_EQ(oxturn("plan stc rectangle --traces" + files).code, 0);
  EXPECT_THAT(content(out / "p.svg"), HasSubstr("id=\"tree\""));
  EXPECT_THAT(oxturn("plan stc rectangle --viewer " + (out / "p.htm")).err, HasSubstr(".html"));
  EXPECT_THAT(oxturn("plan stc rectangle --viewer -").out, StartsWith("<!doctype html>"));
}

TEST_F(Planned, ATetherIsScoredTracedAndDrawn) {
  const std::string map = out.write(
      "ring.geojson",
      R"({"type":"Polygon","coordinates":[[[0,0],[6,0],[6,6],[0,6],[0,0]],[[2,2],[2,4],[4,4],[4,2],[2,2]]]})");
  const std::string path =
      out.write("p.geojson", R"({"type":"FeatureCollection","features":[{"type":"Feature","properties":{"tool":true},)"
                             R"("geometry":{"type":"LineString","coordinates":[[1,1],[5,1],[5,5]]}}]})");
  const std::string problem = "score " + path + " " + map + " --start 1,1 --anchor 1,0 --json";
  const Said said = oxturn(problem + " --robot tether=8,tether_sharp_angle=2 --tether-trace " + (out / "t.csv") +
                           " --svg " + (out / "t.svg"));
  EXPECT_EQ(said.code, 0) << said.err;
  const Json json = Json::parse(said.out);
  EXPECT_EQ(json["anchor"], Json({1.0, 0.0}));
  EXPECT_EQ(json["metrics"]["tether_limit_m"], 8);
  EXPECT_NEAR(json["metrics"]["tether_max_m"].get<double>(), std::sqrt(13) + std::sqrt(10), 1e-12);
  EXPECT_EQ(json["metrics"]["tether_bends_max"], 1);
  EXPECT_EQ(json["metrics"]["tether_entangled"], 0);
  const std::string trace = content(out / "t.csv");
  EXPECT_THAT(trace, StartsWith("path_m,mission_s,x,y,length_m,bends,angle_rad,event\n0,0,1,1,1,0,,start\n"));
  EXPECT_THAT(trace, HasSubstr(",bend_gained\n"));
  EXPECT_THAT(content(out / "t.svg"), HasSubstr("id=\"tether\""));
  EXPECT_THAT(oxturn(problem + " --robot tether=6").err,
              HasSubstr("invalid: pulls its tether to 6.76783 m at (5, 5), 0.768 m over its limit 6 m"));
  // The farthest point is (5.8, 5.8), past the corner (4, 2) or (2, 4): twice that.
  const Json reach = Json::parse(oxturn(problem + " --robot tether_reach=2").out);
  EXPECT_NEAR(reach["metrics"]["tether_limit_m"].get<double>(), 2 * (std::sqrt(13) + std::hypot(1.8, 3.8)), 0.05);
}

TEST(Plan, WhatIsEmptyIsNamedOnOneLineOfTheTable) {
  const Json metrics = Json::parse(oxturn("plan zigzag rectangle --json").out)["metrics"];
  const Said said = oxturn("plan zigzag rectangle");
  EXPECT_THAT(said.out, Not(HasSubstr("; empty")));
  const std::string empty = said.out.substr(said.out.find("\nempty "));
  for (const auto& [name, value] : metrics.items()) {
    EXPECT_EQ(said.out.find("\n" + name + " ") != std::string::npos, !value.is_null()) << name;
    EXPECT_EQ(empty.find(" " + name + ",") != std::string::npos || empty.find(" " + name + " (") != std::string::npos,
              value.is_null())
        << name;
  }
  EXPECT_TRUE(metrics["tether_max_m"].is_null());
}

TEST_F(Planned, ARunKeepsTheTether) {
  const std::string suite = out.write(
      "s.toml",
      "schema = 1\nname = \"s\"\n[robots.leashed]\nradius = 0.2\ntool_width = 0.4\ntether = { reach = 2.0 }\n[[maps]]\n"
      "generator = \"rectangle\"\n[[planners]]\nname = \"zigzag\"\nignore_tether = true\n");
  ASSERT_EQ(oxturn("run " + suite + " -q -o " + (out / "r")).code, 0);
  std::size_t traces = 0;
  for (const auto& entry : std::filesystem::directory_iterator(out / "r/tethers")) {
    ++traces;
    EXPECT_THAT(content(entry.path().string()), HasSubstr(",waypoint\n"));
    EXPECT_TRUE(std::filesystem::exists(out / ("r/pictures/" + entry.path().stem().string() + ".svg")));
    EXPECT_THAT(content(out / ("r/pictures/" + entry.path().stem().string() + ".svg")), HasSubstr("id=\"tether\""));
  }
  EXPECT_EQ(traces, 1u);
}

}  // namespace
}  // namespace oxturn
