// oxturn score: recorded paths, rounded paths, paths that name their problem.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "bench/results.hpp"
#include "maps/path_file.hpp"
#include "tests/cli/program.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;
using Json = nlohmann::json;

class ScoreCommand : public testing::Test {
 protected:
  /// Plans, and keeps path.geojson, which names its problem.
  Json plan(const std::string& arguments) const {
    const Said said = oxturn("plan " + arguments + " --json -o " + (out / "path.geojson"));
    EXPECT_EQ(said.code, 0) << said.err;
    return Json::parse(said.out);
  }
  static Json score(const std::string& arguments) {
    const Said said = oxturn("score " + arguments + " --json");
    EXPECT_EQ(said.code, 0) << said.err;
    return Json::parse(said.out);
  }
  static void expect_refused(const Said& said, const std::string& why) {
    EXPECT_EQ(said.code, 2);
    EXPECT_EQ(said.err_lines(), 1) << said.err;
    EXPECT_THAT(said.err, HasSubstr(why));
  }
  Folder out;
};

template <class Round>
Path rounded(Path path, Round round) {
  for (Leg& leg : path.legs)
    for (Point& p : leg.points) p = {round(p.x()), round(p.y())};
  return path;
}

std::string to_csv(const Path& path) {
  std::string text = "x,y,tool\n";
  for (const Leg& leg : path.legs)
    for (std::size_t i = 0; i + 1 < leg.points.size(); ++i)
      text += to_decimal(leg.points[i].x()) + "," + to_decimal(leg.points[i].y()) + (leg.tool ? ",1\n" : ",0\n");
  const Leg& last = path.legs.back();
  return text + to_decimal(last.points.back().x()) + "," + to_decimal(last.points.back().y()) +
         (last.tool ? ",1\n" : ",0\n");
}

TEST_F(ScoreCommand, RoundedPathsScoreAsTheOriginalWithinTheTolerance) {
  const std::vector<std::pair<std::string, std::string>> runs{
      {"zigzag", "rooms:7 --start corner"},
      {"stc", "clutter:3"},
      {"berg-complete", "rooms:2 --robot tether_reach=1 --anchor wall"}};
  const auto to_float = [](double v) { return static_cast<double>(static_cast<float>(v)); };
  const auto to_millimetre = [](double v) { return std::round(v * 1000) / 1000; };
  for (const auto& [planner, problem] : runs) {
    SCOPED_TRACE(planner);
    const Json original = plan(planner + " " + problem);
    const Path path = read_path(out / "path.geojson");
    const Path floats = rounded(path, to_float), millimetres = rounded(path, to_millimetre);
    const std::vector<std::tuple<std::string, std::string, double>> files{
        {out.write("float.geojson", to_geojson(floats)), "1e-5", 1e-5},
        {out.write("mm.geojson", to_geojson(millimetres)), "0.001", 1e-3},
        {out.write("mm.csv", to_csv(millimetres)), "0.001", 1e-3}};
    for (const auto& [file, tolerance, metres] : files) {
      SCOPED_TRACE(file);
      const Json rough = score(file + " " + problem + " --tolerance " + tolerance);
      EXPECT_EQ(rough["outcome"], original["outcome"]) << rough["reason"];
      EXPECT_NEAR(rough["tolerance_m"].get<double>(), metres, 1e-6);
      const auto difference = [&](const char* metric) {
        return std::abs(rough["metrics"][metric].get<double>() - original["metrics"][metric].get<double>());
      };
      const double path_m = original["metrics"]["path_m"].get<double>();
      EXPECT_LE(difference("coverage"), 0.05 * metres + 1e-3);
      EXPECT_LE(difference("path_m"), 0.05 * path_m * metres / 0.01);
      EXPECT_LE(difference("mission_s"), 0.02 * original["metrics"]["mission_s"].get<double>());
      EXPECT_LE(difference("clearance_m"), metres);
      if (original.contains("anchor")) {
        EXPECT_LE(difference("tether_max_m"), 2 * metres);
        EXPECT_EQ(difference("tether_entangled"), 0);
        EXPECT_EQ(difference("tether_crossings"), 0);
      }
    }
    EXPECT_EQ(oxturn("score " + (out / "mm.geojson") + " " + problem).code, 1);  // not without
  }
}

TEST_F(ScoreCommand, APathAloneIsScoredOnItsProblem) {
  const std::string field = out.write(
      "field.geojson",
      R"({"type":"Feature","properties":{"start":[1,1],"robot":{"radius":0.3,"tool_width":0.5}},"geometry":)"
      R"({"type":"Polygon","coordinates":[[[0,0],[6,0],[6,6],[0,6],[0,0]],[[2,2],[2,4],[4,4],[4,2],[2,2]]]}})");
  const std::string image = out.write("m.pgm", "P2\n4 3\n255\n255 255 255 255\n255 0 255 255\n255 255 255 255\n");
  for (const std::string& problem :
       std::vector<std::string>{"zigzag rooms:18446744073709551615", "stc " + field,
                                "stc " + field + " --start 5,5 --robot speed=2,radius=0.1",
                                "berg-complete " + field + " --robot tether_reach=1.5 --anchor wall",
                                "boustrophedon " + image + " --scale 0.9 --drop-speckle 1"}) {
    SCOPED_TRACE(problem);
    const Json planned = plan(problem);
    Json again = score(out / "path.geojson");
    for (const char* same : {"outcome", "map", "map_sha256", "robot", "start"}) EXPECT_EQ(again[same], planned[same]);
    again["metrics"]["promise_coverage"] = planned["metrics"]["promise_coverage"];  // no path tells it
    EXPECT_EQ(again["metrics"], planned["metrics"]);
  }
  // The robot may be another one.
  EXPECT_EQ(score((out / "path.geojson") + " --robot tool_width=0.1")["robot"]["tool_width"], 0.1);
  expect_refused(oxturn("score " + (out / "path.geojson") + " --scale 0.9"), "give MAP");
}

TEST_F(ScoreCommand, APathOfARunIsScoredAlone) {
  const std::string suite = out.write(
      "s.toml",
      "schema = 1\nname = \"s\"\n[robots.disc]\nradius = 0.2\ntool_width = 0.4\n[[maps]]\ngenerator = \"rooms\"\n"
      "rooms = 3\n[[planners]]\nname = \"stc\"\n");
  ASSERT_EQ(oxturn("run " + suite + " -q -o " + (out / "r")).code, 0);
  std::filesystem::rename(out / "r", out / "moved");
  const Row row = read_results(out / "moved").rows.at(0);
  const Json again = score(out / ("moved/" + row.get("path_file")));
  for (const auto& [name, value] : again["metrics"].items()) {
    if (value.is_null()) continue;
    EXPECT_EQ(to_decimal(value.get<double>()), row.get(name)) << name;
  }
}

TEST_F(ScoreCommand, SaysWhyAProblemCannotBeLoaded) {
  const std::string map =
      out.write("m.geojson", R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[4,3],[0,3],[0,0]]]})");
  plan("zigzag " + map);
  out.write("m.geojson", R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[4,3.001],[0,3],[0,0]]]})");
  expect_refused(oxturn("score " + (out / "path.geojson")), "it was made for another map than '" + map + "' is now");
  std::filesystem::remove(map);
  expect_refused(oxturn("score " + (out / "path.geojson")), "no such file: '" + map + "'; give MAP");
  const std::string csv = out.write("p.csv", "1,1\n2,2\n");
  expect_refused(oxturn("score " + csv), "'" + csv + "' does not name the problem that it was made for; give MAP");
  expect_refused(oxturn("score " + csv + " rectangle --tolerance -1"), "tolerance");
  expect_refused(oxturn("score " + out.write("bad.csv", "1,1\n2,x\n") + " rectangle"),
                 "bad.csv:2: column 2 (y) is 'x'");
}

TEST_F(ScoreCommand, PathsFarAwayAreInvalidNotFatal) {
  const std::string csv = out.write("far.csv", "1e308,1e308\n-1e308,-1e308\n");
  const Said said = oxturn("score " + csv + " rectangle --svg " + (out / "far.svg"));
  EXPECT_EQ(said.code, 1);
  EXPECT_THAT(said.err, HasSubstr("invalid: starts at"));
}

}  // namespace
}  // namespace oxturn
