// Paths from CSV, formats told apart, and problems that paths name.
#include "maps/path_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "base/files.hpp"
#include "tests/support/files.hpp"
#include "tests/support/maps.hpp"

namespace oxturn {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

Path csv(const std::string& text) { return path_from_csv(text, "p.csv"); }
std::string why_not(const std::string& text) {
  return complaint([&] { csv(text); });
}
void expect_legs(const Path& path, const std::vector<Leg>& legs) {
  ASSERT_EQ(path.legs.size(), legs.size());
  for (std::size_t i = 0; i < legs.size(); ++i) {
    EXPECT_EQ(path.legs[i].tool, legs[i].tool) << i;
    EXPECT_EQ(path.legs[i].points, legs[i].points) << i;
    EXPECT_EQ(path.legs[i].gear, legs[i].gear) << i;
  }
}

TEST(PathCsv, WithoutToolIsOneLegOfWork) {
  expect_legs(csv("1,2\n3,4.5\n-1e-3,+7\n"), {{true, {{1, 2}, {3, 4.5}, {-1e-3, 7}}}});
}

TEST(PathCsv, AChangeOfToolBeginsALeg) {
  const std::vector<Leg> legs{{true, {{0, 0}, {1, 0}, {2, 0}}}, {false, {{2, 0}, {3, 0}}}, {true, {{3, 0}, {4, 0}}}};
  expect_legs(csv("0,0,1\n1,0,1\n2,0,0\n3,0,1\n4,0,1\n"), legs);
  expect_legs(csv("0,0,on\n1,0,ON\n2,0,off\n3,0,On\n4,0,off\n"), legs);  // what follows the last point is nothing
  expect_legs(csv("0,0,true\n1,0,True\n2,0,false\n3,0,TRUE\n4,0,true\n"), legs);
}

TEST(PathCsv, AHeaderNamesTheColumns) {
  const std::vector<Leg> legs{{false, {{1, 2}, {3, 4}}}};
  expect_legs(csv("x,y,tool\n1,2,0\n3,4,0\n"), legs);
  expect_legs(csv("\"time\" , \"Y\",\"X\",tool,quality\n12:00,2,1,off,bad\n12:01,4,3,off,\n"), legs);
}

TEST(PathCsv, AChangeOfGearBeginsALeg) {
  const std::vector<Leg> legs{
      {true, {{0, 0}, {1, 0}}}, {true, {{1, 0}, {2, 0}}, Gear::reverse}, {false, {{2, 0}, {3, 0}}, Gear::reverse}};
  expect_legs(csv("0,0,1,0\n1,0,1,1\n2,0,0,on\n3,0,0,1\n"), legs);
  expect_legs(csv("reverse,x,y,tool\nfalse,0,0,1\n1,1,0,1\n1,2,0,0\n1,3,0,0\n"), legs);
  EXPECT_EQ(why_not("1,2,1,x\n1,2,1,0\n"),
            "p.csv:1: column 4 (reverse) is 'x', expected 1 or 0, on or off, true or false");
}

TEST(PathGeoJson, GearsAreReadBackAndForwardsIsNotWritten) {
  const Path path{{Leg{true, {{0, 0}, {1, 0}}}, Leg{true, {{1, 0}, {0, 0}}, Gear::reverse}}};
  const std::string text = to_geojson(path);
  expect_legs(path_from_geojson(text, "p.geojson").path, path.legs);
  EXPECT_EQ(text.find("reverse"), text.rfind("reverse"));
  EXPECT_THAT(complaint([] {
                path_from_geojson(R"({"type": "FeatureCollection", "features": [{"type": "Feature",
                    "properties": {"tool": true, "reverse": 1},
                    "geometry": {"type": "LineString", "coordinates": [[0, 0], [1, 0]]}}]})",
                                  "p.geojson");
              }),
              HasSubstr("reverse is 1, expected true or false"));
}

TEST(PathCsv, LineEndsMarksCommentsAndBlanks) {
  const std::vector<Leg> legs{{true, {{1, 2}, {3, 4}}}};
  expect_legs(csv("\xEF\xBB\xBFx,y\r\n1,2\r\n3,4"), legs);
  expect_legs(csv("# by hand\n\n  1 ,\t2 \n# nothing\n   \n\"3\",4\n\n"), legs);
}

TEST(PathCsv, BadLinesAreNamedByLineAndColumn) {
  EXPECT_EQ(why_not(""), "p.csv has 0 points, expected at least 2");
  EXPECT_EQ(why_not("x,y\n"), "p.csv has 0 points, expected at least 2");
  EXPECT_EQ(why_not("1,2\n"), "p.csv has 1 point, expected at least 2");
  EXPECT_EQ(why_not("1,2\n1,nan\n"), "p.csv:2: column 2 (y) is 'nan', expected a finite number in metres");
  EXPECT_EQ(why_not("inf,2\n1,3\n"), "p.csv:1: column 1 (x) is 'inf', expected a finite number in metres");
  EXPECT_EQ(why_not("1,2\n\n1e999,3\n"), "p.csv:3: column 1 (x) is '1e999', expected a finite number in metres");
  EXPECT_EQ(why_not("1,2\n1,\n"), "p.csv:2: column 2 (y) is '', expected a finite number in metres");
  EXPECT_EQ(why_not("1,2,3\n1,2,1\n"), "p.csv:1: column 3 (tool) is '3', expected 1 or 0, on or off, true or false");
  EXPECT_EQ(why_not("1,2\n1,2,1\n"), "p.csv:2: 3 columns, expected 2");
  EXPECT_EQ(why_not("1\n2\n"), "p.csv:1: 1 column, expected x,y[,tool[,reverse[,width]]]");
  EXPECT_EQ(
      why_not("1;2\n3;4\n"),
      "p.csv:1: begins with '1;2', expected numbers x,y[,tool[,reverse[,width]]] or a header with the columns x and y");
  EXPECT_THAT(why_not("lat,lon\n1,2\n"), HasSubstr("begins with 'lat'"));
  EXPECT_THAT(why_not(std::string("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16)),
              StartsWith("p.csv:1: begins with '\xEF\xBF\xBDPNG'"));
  EXPECT_THAT(why_not(std::string(1 << 20, ',')), StartsWith("p.csv:1: begins with ''"));
  EXPECT_LT(why_not("1,2\n" + std::string(1 << 20, '7') + "x,1\n").size(), 200u);
}

TEST(PathCsv, HugeNumbersAreNumbers) {
  expect_legs(csv("1e308,-1e308\n5e-324,0\n"), {{true, {{1e308, -1e308}, {5e-324, 0}}}});
}

TEST(PathCsv, AMillionLines) {
  std::string text = "x,y,tool\n";
  for (int i = 0; i < 1'000'000; ++i) text += i % 1000 < 900 ? "1.25,2.5,1\n" : "3.125,4.75,0\n";
  const Path path = csv(text);
  EXPECT_EQ(path.legs.size(), 2000u);
  std::size_t points = 0;
  for (const Leg& leg : path.legs) points += leg.points.size();
  EXPECT_EQ(points, 1'000'000u + 1999u);
}

TEST(PathFiles, TheFormatIsToldBySuffixOrContent) {
  const TemporaryFolder folder;
  const Path path{{Leg{true, {{0, 0}, {1, 0}}}}};
  for (const std::string name : {"a.geojson", "a.JSON", "a.txt", "a"}) {
    write_file(folder.file(name), "\n " + to_geojson(path));
    expect_legs(read_path(folder.file(name)), path.legs);
  }
  for (const std::string name : {"b.csv", "b.CSV", "b.txt", "b"}) {
    write_file(folder.file(name), "0,0\n1,0\n");
    expect_legs(read_path(folder.file(name)), path.legs);
  }
  write_file(folder.file("c.geojson"), "0,0\n1,0\n");
  EXPECT_THAT(complaint([&] { read_path(folder.file("c.geojson")); }), HasSubstr("not JSON"));
}

class NamedProblem : public ::testing::Test {
 protected:
  std::string store(const Problem& problem, const MapSource& source) {
    const PathProblem named = path_problem(problem, source);
    write_file(folder.file("p.geojson"), to_geojson(Path{{Leg{true, {{1, 1}, {2, 1}}}}}, &named));
    return folder.file("p.geojson");
  }
  static MapFile load(const std::string& file) {
    return load_map(read_path_file(file).problem.value(), file, built_in_maps(), built_in_formats());
  }
  TemporaryFolder folder;
};

TEST_F(NamedProblem, IsMadeAgain) {
  Robot tethered;
  tethered.tether = Tether{};
  tethered.tether->reach = 1.3;
  Robot octagon;
  octagon.name = "oct, \"agon\"";
  octagon.footprint = {{0.5, -0.2}, {0.5, 0.2}, {-0.5, 0.2}, {-0.5, -0.2}};
  for (const Robot& robot : {Robot{}, tethered, octagon}) {
    const MapSource source{.generator = "rooms", .settings = {{"rooms", std::int64_t{4}}}, .seed = ~std::uint64_t{0}};
    const Problem problem(load_map(source, built_in_maps(), built_in_formats()).map, robot);
    const MapFile again = load(store(problem, source));
    EXPECT_EQ(Problem(again.map, again.robot.value(), again.start, again.anchor).content_hash(),
              problem.content_hash());
  }
}

TEST_F(NamedProblem, FilesAreRelativeToThePath) {
  const Map map = generate("rectangle", {}, 1);
  const Problem problem(map, Robot{});
  std::filesystem::create_directory(folder.file("maps"));
  write_file(folder.file("maps/m.geojson"), to_geojson(problem));
  const std::string file = store(problem, {.file = "maps/m.geojson"});
  EXPECT_EQ(content_hash(load(file).map), content_hash(map));
  write_file(folder.file("maps/m.geojson"), to_geojson(Problem(generate("rectangle", {{"width", 7.5}}, 1), Robot{})));
  EXPECT_THAT(complaint([&] { load(file); }),
              AllOf(StartsWith(file), HasSubstr("made for another map than"), HasSubstr("give MAP")));
  std::filesystem::remove(folder.file("maps/m.geojson"));
  EXPECT_THAT(complaint([&] { load(file); }), AllOf(HasSubstr("no such file"), HasSubstr("give MAP")));
}

TEST_F(NamedProblem, BadOnesAreNamed) {
  const auto complains = [](const std::string& problem) {
    return complaint(
        [&] { path_from_geojson(R"({"type":"FeatureCollection","features":[],"problem":)" + problem + "}", "p"); });
  };
  EXPECT_EQ(complains("null"), "");
  EXPECT_EQ(complains("3"), "p: problem is 3, expected an object");
  EXPECT_EQ(complains("{}"), "p: problem has no generator, expected a generator's name, or file");
  EXPECT_EQ(complains(R"({"generator":"rooms","seed":-1})"), "p: problem.seed is -1, expected a whole number from 0");
  EXPECT_EQ(complains(R"({"file":"a.png","map_sha256":"","start":[1]})"),
            "p: problem.start is [1], expected [x, y], two numbers in metres");
  EXPECT_THAT(complains(R"({"file":"a","map_sha256":"","start":[1,1],"anchor":[1,1],"robot":{"radius":-1}})"),
              HasSubstr("radius"));
}

}  // namespace
}  // namespace oxturn
