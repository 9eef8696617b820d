// Every kind of bad input: one sentence that names the thing, the position and the remedy; exit code 2; no file left
// behind.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/program.hpp"

namespace oxturn {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

void expect_refused(const Said& said, const testing::Matcher<const std::string&>& sentence) {
  EXPECT_EQ(said.code, 2) << said.err;
  EXPECT_EQ(said.err_lines(), 1) << said.err;
  EXPECT_THAT(said.err, StartsWith("oxturn: "));
  EXPECT_THAT(said.err, sentence);
  EXPECT_EQ(said.out, "");
}

const char* const kBox =
    R"({"type":"Feature","properties":{"name":"box","robot":{"radius":0.2,"tool_width":0.4},"start":[1,1]},)"
    R"("geometry":{"type":"Polygon","coordinates":[[[0,0],[4,0],[4,3],[0,3],[0,0]]]}})";

class BadInput : public testing::Test {
 protected:
  Folder in, out;
  std::string box = in.write("box.geojson", kBox);
  std::string to = " -o " + (out / "path.geojson") + " --svg " + (out / "path.svg");
  void TearDown() override { EXPECT_EQ(out.files(), 0u); }
};

TEST_F(BadInput, MissingFile) {
  expect_refused(oxturn("plan boustrophedon " + (in / "none.geojson") + to),
                 AllOf(HasSubstr("no such file"), HasSubstr("none.geojson")));
}
TEST_F(BadInput, TomlWithItsLine) {
  const std::string suite = in.write("bad.toml", "schema = 1\nname = \"x\"\nseed = = 3\n");
  expect_refused(oxturn("run " + suite + " -o " + (out / "r")), HasSubstr("bad.toml:3"));
}
TEST_F(BadInput, UnknownPlannerWithTheNearest) {
  expect_refused(oxturn("plan boustrofedon " + box + to),
                 AllOf(HasSubstr("'boustrofedon'"), HasSubstr("did you mean 'boustrophedon'")));
}
TEST_F(BadInput, UnknownParameterWithTheList) {
  expect_refused(oxturn("plan stc " + box + " --set lane_width=3" + to),
                 AllOf(HasSubstr("unknown parameter 'lane_width' of planner 'stc'"), HasSubstr("it has: ")));
}
TEST_F(BadInput, SettingsThatExcludeEachOther) {
  const auto needs_exact_cells =
      AllOf(HasSubstr("order 'postman' needs cells with two ends"), HasSubstr("set cells to"));
  expect_refused(oxturn("plan boustrophedon " + box + " --set order=postman --set cells=slab" + to), needs_exact_cells);
  expect_refused(
      oxturn("plan completed " + box + " --set planner=boustrophedon --set order=postman --set cells=slab" + to),
      needs_exact_cells);
  for (const char* planner : {"ba-star", "stc-scan", "bsa", "smart-dfs"})
    expect_refused(oxturn(fmt::format("plan {} {} --set align=edges --set sensing=lidar{}", planner, box, to)),
                   HasSubstr("align = edges needs the map"));
  expect_refused(oxturn("plan linked-spiral " + box + " --set partial=true --set sensing=lidar" + to),
                 HasSubstr("partial = true needs the map"));
  const std::string suite = in.write("both.toml",
                                     "schema = 1\nname = \"both\"\n[robots.r]\nradius = 0.2\n[[maps]]\n"
                                     "generator = \"rectangle\"\n[[planners]]\nname = \"boustrophedon\"\n"
                                     "order = \"postman\"\ncells = [\"exact\", \"slab\"]\n");
  expect_refused(oxturn("run " + suite + " -o " + (out / "r")), AllOf(HasSubstr("both.toml:8: "), needs_exact_cells));
}
TEST_F(BadInput, AGeneratorsParameterAmongThePlanners) {
  expect_refused(oxturn("plan stc rooms:3 --set rooms=3" + to),
                 AllOf(HasSubstr("'rooms' is a parameter of generator 'rooms', not of planner 'stc'"),
                       HasSubstr("write the map as rooms:3,rooms=3")));
}
TEST_F(BadInput, SettingsOfAGeneratorInTheMapsName) {
  expect_refused(oxturn("plan stc rooms:3,size=3" + to),
                 AllOf(HasSubstr("unknown parameter 'size' of generator 'rooms'"), HasSubstr("it has: ")));
  expect_refused(oxturn("plan stc rooms:3,rooms=many" + to), AllOf(HasSubstr("rooms"), HasSubstr("many")));
  expect_refused(oxturn("plan stc rooms:3," + to), HasSubstr("map 'rooms:3,': setting '': expected name=value"));
  expect_refused(oxturn("plan stc rooms:x,rooms=3" + to), HasSubstr("seed is 'x', expected a whole number from 0"));
  expect_refused(oxturn("plan stc rom:3,rooms=3" + to), AllOf(HasSubstr("'rom'"), HasSubstr("did you mean 'rooms'")));
  expect_refused(oxturn("map rooms,rooms=3 --set rooms=4 -o " + (out / "m.geojson")),
                 HasSubstr("rooms is given twice: by 'rooms,rooms=3' and by --set"));
}
TEST_F(BadInput, WrongType) {
  expect_refused(oxturn("map rooms --set rooms=many -o " + (out / "m.geojson")),
                 AllOf(HasSubstr("rooms"), HasSubstr("many")));
}
TEST_F(BadInput, SelfCrossingPolygonWithItsPosition) {
  const std::string bow =
      in.write("bow.geojson", R"({"type":"Polygon","coordinates":[[[0,0],[4,4],[4,0],[0,4],[0,0]]]})");
  expect_refused(oxturn("plan zigzag " + bow + to), AllOf(HasSubstr("bow.geojson"), HasSubstr("(2, 2)")));
}
TEST_F(BadInput, StartInAWallWithTheNearestPoint) {
  expect_refused(oxturn("plan zigzag " + box + " --start 9,1" + to),
                 AllOf(HasSubstr("start (9, 1)"), HasSubstr("nearest point"), HasSubstr("(3.")));
}
TEST_F(BadInput, NaN) {
  expect_refused(oxturn("plan zigzag " + box + " --start nan,1" + to), HasSubstr("nan"));
  const std::string nan =
      in.write("nan.geojson", R"({"type":"Polygon","coordinates":[[[0,0],[4,0],[NaN,4],[0,4],[0,0]]]})");
  expect_refused(oxturn("plan zigzag " + nan + to), HasSubstr("nan.geojson"));
}
TEST_F(BadInput, ZeroToolWidth) {
  expect_refused(oxturn("plan zigzag " + box + " --tool-width 0" + to), HasSubstr("tool-width"));
  expect_refused(oxturn("plan zigzag " + box + " --robot radius=0.1,tool_width=0" + to), HasSubstr("tool_width"));
}
TEST_F(BadInput, UnwritableOutput) {
  for (const std::string& command :
       {"plan zigzag " + box + " -o ", "plan zigzag " + box + " --svg ", std::string("map rooms -o ")}) {
    const std::string suffix = command.ends_with("--svg ") ? ".svg" : ".geojson";
    expect_refused(oxturn(command + "/nowhere/at/all/x" + suffix), HasSubstr("cannot write '/nowhere/at/all/x"));
  }
  const std::string suite = in.write("s.toml",
                                     "schema = 1\nname = \"s\"\n[robots.disc]\nradius = 0.2\ntool_width = 0.4\n"
                                     "[[maps]]\ngenerator = \"rectangle\"\n[[planners]]\nname = \"stc\"\n");
  expect_refused(oxturn("run " + suite + " -o /proc/nowhere"), HasSubstr("/proc/nowhere"));
}

// And what else fingers do.
TEST_F(BadInput, UnknownCommandWithTheNearest) {
  expect_refused(oxturn("plam x y"), AllOf(HasSubstr("'plam'"), HasSubstr("did you mean 'plan'")));
  expect_refused(oxturn(""), HasSubstr("no command"));
}
TEST_F(BadInput, UnknownOptionWithTheNearest) {
  expect_refused(oxturn("run quick -o " + (out / "r") + " --job 3"), HasSubstr("did you mean '--jobs'"));
}
TEST_F(BadInput, MissingArguments) {
  expect_refused(oxturn("plan stc"), HasSubstr("MAP"));
  expect_refused(oxturn("map rooms"), HasSubstr("output"));
}
TEST_F(BadInput, NumbersThatAreNone) {
  expect_refused(oxturn("plan stc " + box + " --radius wide" + to), HasSubstr("wide"));
  expect_refused(oxturn("plan stc " + box + " --radius inf" + to), HasSubstr("inf"));
  expect_refused(oxturn("plan stc " + box + " --wall -1" + to), HasSubstr("--wall"));
  expect_refused(oxturn("plan stc " + box + " --robot speed=fast" + to), HasSubstr("fast"));
  expect_refused(oxturn("plan stc " + box + " --robot colour=1" + to),
                 AllOf(HasSubstr("colour"), HasSubstr("it has:")));
  expect_refused(oxturn("plan stc rooms --seed -3" + to), HasSubstr("'-3'"));
  expect_refused(oxturn("plan stc rooms:x" + to), HasSubstr("'x'"));
  expect_refused(oxturn("plan stc " + box + " --start 1" + to), HasSubstr("X,Y"));
}
TEST_F(BadInput, Tethers) {
  expect_refused(oxturn("plan stc " + box + " --anchor here" + to),
                 HasSubstr("--anchor is 'here', expected X,Y: two finite numbers in metres"));
  expect_refused(oxturn("plan stc " + box + " --robot tether=5,tether_reach=2" + to),
                 HasSubstr("tether has a length and a reach, expected one of the two"));
  expect_refused(oxturn("plan stc " + box + " --robot tether=0" + to), HasSubstr("tether has no length"));
  expect_refused(oxturn("plan stc " + box + " --robot tether_sharp_angle=2" + to), HasSubstr("tether has no length"));
  expect_refused(oxturn("plan stc " + box + " --robot tether=5,tether_sharp_angle=4" + to),
                 HasSubstr("'tether_sharp_angle' of a robot is 4"));
  expect_refused(oxturn("plan stc " + box + " --robot tether=5 --anchor 9,9" + to), HasSubstr("anchor (9, 9)"));
  expect_refused(oxturn("plan stc " + box + " --robot tether=0.5 --anchor 3,1" + to), HasSubstr("too short"));
  expect_refused(oxturn("plan stc " + box + " --tether-trace " + (out / "t.csv") + to), HasSubstr("has no tether"));
  expect_refused(oxturn("plan stc " + box + " --robot tether=5 --tether-trace " + (out / "t.txt") + to),
                 HasSubstr(".csv"));
  expect_refused(oxturn("plan stc " + box + " --tethers -1" + to), HasSubstr("--tethers"));
}
TEST_F(BadInput, SuffixNobodyWrites) {
  expect_refused(oxturn("map rooms -o " + (out / "m.dxf")), HasSubstr(".geojson"));
}
TEST_F(BadInput, GeneratorThatIsNone) {
  expect_refused(oxturn("map room -o " + (out / "m.svg")), HasSubstr("did you mean 'rooms'"));
  expect_refused(oxturn("plan stc room:3" + to), HasSubstr("did you mean 'rooms'"));
}
TEST_F(BadInput, FolderThatHoldsNoResults) {
  const Folder empty;
  expect_refused(oxturn("report " + (empty / ".")), HasSubstr("runs.csv"));
}
TEST_F(BadInput, PathThatIsNone) {
  const std::string text = in.write("p.geojson", "{\"type\":");
  expect_refused(oxturn("score " + text + " " + box), HasSubstr("p.geojson"));
}
TEST_F(BadInput, ListOfNothing) { expect_refused(oxturn("list planer"), HasSubstr("did you mean 'planners'")); }
TEST_F(BadInput, ListOfNoSuchPlanner) {
  expect_refused(oxturn("list planners zigzak"), AllOf(HasSubstr("zigzak"), HasSubstr("did you mean 'zigzag'")));
}

}  // namespace
}  // namespace oxturn
