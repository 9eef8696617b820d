#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "base/files.hpp"
#include "base/random.hpp"
#include "maps/formats.hpp"
#include "maps/path_file.hpp"
#include "tests/support/drawn.hpp"
#include "tests/support/files.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string sample(const std::string& name) { return OXTURN_SOURCE_DIR "/tests/data/geojson/" + name; }

/// The error message for a file with this content, without the folder's name.
std::string why(const std::string& content) {
  const TemporaryFolder folder;
  write_file(folder.file("m.geojson"), content);
  std::string text = complaint([&] { read_map(folder.file("m.geojson")); });
  EXPECT_EQ(text.find('\n'), std::string::npos) << text;
  const std::string prefix = folder.path().string() + "/";
  for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
  return text;
}
MapFile read(const std::string& content) {
  const TemporaryFolder folder;
  write_file(folder.file("m.geojson"), content);
  return read_map(folder.file("m.geojson"));
}

const std::string kSquare = R"({"type": "Polygon", "coordinates": [[[0,0],[4,0],[4,4],[0,4],[0,0]]]})";
std::string feature(const std::string& geometry, const std::string& properties) {
  return R"({"type": "Feature", "geometry": )" + geometry + R"(, "properties": )" + properties + "}";
}

TEST(GeoJson, WholeProblem) {
  const MapFile m = read_map(sample("flat.geojson"));
  EXPECT_EQ(m.map.name, "flat");
  EXPECT_EQ(m.map.family, "file");
  EXPECT_EQ(m.map.source, "drawn by hand");
  EXPECT_DOUBLE_EQ(area(m.map.free), 10 * 8 - 2 * 2);
  EXPECT_EQ(hole_count(m.map.free), 1u);
  EXPECT_EQ(m.start, Point(1, 1.5));
  EXPECT_EQ(m.anchor, Point(0.5, 0.5));
  ASSERT_TRUE(m.robot);
  EXPECT_EQ(m.robot->name, "cleaner");
  EXPECT_EQ(m.robot->radius, 0.25);
  EXPECT_EQ(m.robot->tool_width, 0.5);
  EXPECT_EQ(m.robot->speed, 0.7);
  EXPECT_EQ(m.robot->acceleration, 0.9);
  EXPECT_EQ(m.robot->turn_rate, 2.0);
  EXPECT_EQ(m.robot->min_turn_radius, 0.125);
  ASSERT_TRUE(m.robot->tether && m.robot->lidar);
  EXPECT_EQ(m.robot->tether->length, 30.0);
  EXPECT_EQ(m.robot->lidar->range, 8.0);
  EXPECT_EQ(m.robot->lidar->rays, 360);
  EXPECT_TRUE(m.remarks.empty());
}

TEST(GeoJson, GeometryInEveryKindOfObject) {
  const auto size = [](const std::string& s) { return area(read(s).map.free); };
  EXPECT_DOUBLE_EQ(size(kSquare), 16);
  EXPECT_DOUBLE_EQ(size(feature(kSquare, "null")), 16);
  EXPECT_DOUBLE_EQ(size(R"({"type":"MultiPolygon","coordinates":[[[[0,0],[1,0],[1,1]]],[[[5,5],[5,7],[7,7],[7,5]]]]})"),
                   4.5);
  const MapFile m = read(R"({"type":"FeatureCollection","features":[
      {"type":"Feature","properties":{},"geometry":{"type":"Point","coordinates":[1,1]}},
      {"type":"Feature","properties":{"name":"yard"},"geometry":)" +
                         kSquare + "}]}");
  EXPECT_EQ(m.map.name, "yard");
  EXPECT_THAT(m.remarks, testing::ElementsAre("1 features that are not polygons are ignored"));
  EXPECT_EQ(read(kSquare).map.name, "m");
}

TEST(GeoJson, OrientationClosingAndAltitudeMakeNoDifference) {
  const std::string hash = content_hash(read(kSquare).map);
  EXPECT_EQ(content_hash(read(R"({"type":"Polygon","coordinates":[[[0,0],[0,4],[4,4],[4,0]]]})").map), hash);
  EXPECT_EQ(content_hash(read(R"({"type":"Polygon","coordinates":[[[4,0,9],[4,4,9],[0,4,9],[0,0,9],[4,0,9]]]})").map),
            hash);
}

TEST(GeoJson, RepairsAreRemarks) {
  // A point on an edge, and two holes side by side.
  const MapFile m = read(R"({"type":"Polygon","coordinates":[[[0,0],[5,0],[10,0],[10,10],[0,10]],
      [[2,2],[2,4],[4,4],[4,2]], [[4,2],[4,4],[6,4],[6,2]]]})");
  EXPECT_DOUBLE_EQ(area(m.map.free), 92);
  EXPECT_EQ(hole_count(m.map.free), 1u);
  ASSERT_EQ(m.remarks.size(), 2u);
  EXPECT_THAT(m.remarks[0], HasSubstr("2 holes became 1"));
  EXPECT_THAT(m.remarks[1], HasSubstr("13 vertices became 8"));
}

TEST(GeoJson, BadContentIsOneSentenceThatNamesThePart) {
  EXPECT_THAT(why("{\n\"type\": \"Feature\",\n\"geometry\": nope}"), StartsWith("m.geojson:3: not JSON: "));
  EXPECT_THAT(why(""), StartsWith("m.geojson:1: not JSON: "));
  EXPECT_THAT(why(R"({"type":"Polygon","coordinates":[[[0,0],[4,NaN],[4,4]]]})"),
              StartsWith("m.geojson:1: not JSON: "));
  EXPECT_THAT(why(R"({"type":"Polygon","coordinates":[[[0,0],[1e999,0],[4,4]]]})"), StartsWith("m.geojson"));
  EXPECT_EQ(why("[1]"), "m.geojson is [1], expected a GeoJSON Feature, Polygon, MultiPolygon or FeatureCollection");
  EXPECT_EQ(why("{}"), "m.geojson has no type, expected a GeoJSON Feature, Polygon, MultiPolygon or FeatureCollection");
  EXPECT_THAT(why(R"({"type":"LineString","coordinates":[]})"), StartsWith("m.geojson is a LineString, expected"));
  EXPECT_EQ(why(feature("null", "{}")), "m.geojson: geometry is missing, expected a Polygon or MultiPolygon");
  EXPECT_EQ(why(feature(R"({"type":"Point","coordinates":[1,2]})", "{}")),
            "m.geojson: geometry is a Point, expected a Polygon or MultiPolygon");
  EXPECT_EQ(why(R"({"type":"Polygon","coordinates":[]})"),
            "m.geojson: geometry has no coordinates, expected a list of rings");
  EXPECT_EQ(why(R"({"type":"Polygon","coordinates":[[[0,0],["a",0],[4,4]]]})"),
            "m.geojson: polygon 1, ring 1, point 2 is [\"a\",0], expected [x, y], two numbers in metres");
  EXPECT_EQ(why(R"({"type":"MultiPolygon","coordinates":[[[[0,0],[1,0],[1,1]]],[[[5,5],null,[7,7]]]]})"),
            "m.geojson: polygon 2, ring 1, point 2 is null, expected [x, y], two numbers in metres");
  EXPECT_EQ(why(R"({"type":"Polygon","coordinates":[[[0,0],[1,1],[0,0]]]})"),
            "m.geojson: polygon 1, ring 1 has 2 different points, expected at least 3");
  EXPECT_EQ(why(R"({"type":"FeatureCollection","features":[]})"),
            "m.geojson has 0 features that are a Polygon or MultiPolygon, expected exactly one");
  EXPECT_THAT(why(R"({"type":"FeatureCollection","features":[1,)" + feature(kSquare, "{}") + "," +
                  feature(kSquare, "{}") + "]}"),
              StartsWith("m.geojson has 2 features"));
}

TEST(GeoJson, ASelfCrossingPolygonIsReportedWithThePoint) {
  const std::string text = complaint([] { read_map(sample("crossed.geojson")); });
  EXPECT_THAT(text, HasSubstr("crossed.geojson: edges cross at (1, 1)"));
}

TEST(GeoJson, BadPropertiesAreNamed) {
  const auto with = [](const std::string& properties) { return why(feature(kSquare, properties)); };
  EXPECT_EQ(
      with(R"({"robot":{"radius":0.2,"toolwidth":0.4}})"),
      "m.geojson: unknown parameter 'toolwidth' of robot 'disc'; it has: name, radius, footprint, tool_width, speed, "
      "acceleration, turn_rate, min_turn_radius, reverse, tether_length, tether_reach, tether_sharp_angle, "
      "lidar_range, lidar_rays, lidar_noise");
  EXPECT_EQ(with(R"({"robot":{"radius":"0.2"}})"),
            "m.geojson: parameter 'radius' of robot 'disc' is '0.2', expected a number from 0 to 1e+09");
  EXPECT_EQ(with(R"({"robot":{"tool_width":0}})"),
            "m.geojson: parameter 'tool_width' of robot 'disc' is 0, expected a number above 0, at most 1e+09");
  EXPECT_EQ(with(R"({"robot":{"tether":40}})"), "m.geojson: robot.tether is 40, expected an object with members");
  EXPECT_EQ(with(R"({"robot":{"tether":{}}})"), "m.geojson: robot.tether is {}, expected an object with members");
  EXPECT_EQ(with(R"({"robot":{"lidar":{"range":3,"rays":0.5}}})"),
            "m.geojson: parameter 'lidar_rays' of robot 'disc' is 0.5, expected a whole number from 1 to 1e+06");
  EXPECT_EQ(with(R"({"robot":[1]})"), "m.geojson: robot is [1], expected an object with members");
  EXPECT_EQ(with(R"({"start":[1]})"), "m.geojson: start is [1], expected [x, y], two numbers in metres");
  EXPECT_EQ(with(R"({"start":"here"})"), "m.geojson: start is \"here\", expected [x, y], two numbers in metres");
  EXPECT_EQ(with(R"({"name":7})"), "m.geojson: name is 7, expected a string");
  EXPECT_EQ(with("[]"), "m.geojson: properties is [], expected an object");
}

TEST(GeoJson, RandomDamageNeverCrashes) {
  const std::string good = read_file(sample("flat.geojson"));
  int refused = 0;
  for (const auto seed : seeds(300)) {
    Rng rng(seed);
    std::string bad = good;
    for (int k = rng.between(1, 6); k > 0; --k) {
      const std::size_t at = rng.below(bad.size());
      if (rng.chance(0.3))
        bad.erase(at, rng.below(20));
      else
        bad[at] = "[]{},:\"0-9eE. nx"[rng.below(16)];
      if (bad.empty()) bad = " ";
    }
    const TemporaryFolder folder;
    write_file(folder.file("m.geojson"), bad);
    try {
      read_map(folder.file("m.geojson"));
    } catch (const std::invalid_argument& e) {  // any other exception fails the test
      ++refused;
      EXPECT_THAT(e.what(), HasSubstr("m.geojson"));
    }
  }
  EXPECT_GT(refused, 100);
}

TEST(GeoJson, ProblemReadsBackTheSame) {
  Robot robot;
  robot.radius = 0.1;
  robot.tool_width = 1.0 / 3;
  robot.tether = Tether{12.5};
  robot.lidar = Lidar{7, 90, 0.02};
  const Problem p =
      drawn({"######", "#S..A#", "#.##.#", "#....#", "######"}, {.cell = 0.7, .robot = robot, .name = "a \"b\"\n\\"});
  const std::string text = to_geojson(p);
  const MapFile m = read(text);
  EXPECT_TRUE(m.remarks.empty());
  EXPECT_EQ(m.map.name, "a \"b\"\n\\");
  const Problem q(m.map, *m.robot, m.start, m.anchor);
  EXPECT_EQ(q.content_hash(), p.content_hash());
  EXPECT_EQ(to_geojson(q), text);
  const auto json = nlohmann::json::parse(text);  // RFC 7946: rings are closed
  const auto& ring = json["geometry"]["coordinates"][0];
  EXPECT_EQ(ring.front(), ring.back());
}

TEST(GeoJson, MapFileWithoutAProblemHasOnlyItsOwnProperties) {
  MapFile m;
  m.map = {"two", {{{{{0, 0}, {1, 0}, {1, 1}}, {}}, {{{5, 5}, {6, 5}, {6, 6}}, {}}}}, "file", "x"};
  const auto json = nlohmann::json::parse(to_geojson(m));
  EXPECT_EQ(json["geometry"]["type"], "MultiPolygon");
  EXPECT_FALSE(json["properties"].contains("start"));
  EXPECT_FALSE(json["properties"].contains("robot"));
  EXPECT_DOUBLE_EQ(area(read(to_geojson(m)).map.free), 1.0);
}

Path random_path(std::uint64_t seed) {
  Rng rng(seed);
  Path path;
  Point at(rng.normal(), rng.normal());
  for (int leg = 0; leg < 5; ++leg) {
    Leg l{leg % 2 == 0, {at}};
    for (int k = rng.between(1, 20); k > 0; --k) l.points.push_back(at = at + Point(rng.normal(), rng.normal()) * 1e3);
    path.legs.push_back(l);
  }
  return path;
}

TEST(PathGeoJson, ReadsBackExactly) {
  for (const auto seed : seeds(20)) {
    const Path path = random_path(seed);
    const Path again = path_from_geojson(to_geojson(path), "p").path;
    ASSERT_EQ(again.legs.size(), path.legs.size());
    for (std::size_t i = 0; i < path.legs.size(); ++i) {
      EXPECT_EQ(again.legs[i].tool, path.legs[i].tool);
      EXPECT_EQ(again.legs[i].points, path.legs[i].points);
    }
  }
  EXPECT_TRUE(path_from_geojson(to_geojson(Path{}), "p").path.legs.empty());
}

TEST(PathGeoJson, BadPathsAreNamedByFeatureAndPoint) {
  const auto why_not = [](const std::string& text) { return complaint([&] { path_from_geojson(text, "p.geojson"); }); };
  const auto one = [&](const std::string& f) {
    return why_not(R"({"type":"FeatureCollection","features":[)" + f + "]}");
  };
  const auto line = [&](const std::string& points) {
    return one(R"({"type":"Feature","properties":{"tool":true},"geometry":{"type":"LineString","coordinates":)" +
               points + "}}");
  };
  EXPECT_THAT(why_not("{\n]"), StartsWith("p.geojson:2: not JSON: "));
  EXPECT_EQ(why_not(R"({"type":"Feature"})"), "p.geojson: type is \"Feature\", expected FeatureCollection");
  EXPECT_EQ(why_not(R"({"type":"FeatureCollection"})"), "p.geojson has no features, expected a list of LineStrings");
  EXPECT_EQ(one("3"), "p.geojson: feature 1 is 3, expected an object");
  EXPECT_EQ(one(R"({"properties":{},"geometry":{"type":"LineString"}})"),
            "p.geojson: feature 1, properties has no tool, expected true or false");
  EXPECT_EQ(one(R"({"properties":{"tool":1},"geometry":{"type":"LineString"}})"),
            "p.geojson: feature 1, tool is 1, expected true or false");
  EXPECT_EQ(line("[[0,0]]"), "p.geojson: feature 1, coordinates is [[0,0]], expected a list of at least two points");
  EXPECT_EQ(line("[[0,0],[1,null]]"),
            "p.geojson: feature 1, point 2 is [1,null], expected [x, y], two numbers in metres");
  Path nan = random_path(1);
  nan.legs[2].points[1].x() = std::nan("");
  EXPECT_THAT(why_not(to_geojson(nan)), StartsWith("p.geojson: feature 3, point 2 is [null,"));
}

}  // namespace
}  // namespace oxturn
