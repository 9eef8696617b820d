// "-": standard input and output in the position of a file's name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/program.hpp"

namespace oxturn {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using Json = nlohmann::json;

TEST(Streams, APathGoesThroughAPipe) {
  const Folder folder;
  const std::string planned = "oxturn plan boustrophedon rooms:3 -o - 2>/dev/null";
  const Said named = shell(planned + " | oxturn score - rooms:3 --json"),
             unnamed = shell(planned + " | oxturn score - --json");
  ASSERT_EQ(named.code, 0) << named.err;
  EXPECT_EQ(named.out, unnamed.out) << "the path names its problem";
  const std::string file = folder / "path.geojson";
  ASSERT_EQ(oxturn("plan boustrophedon rooms:3 -o " + file).code, 0);
  Json by_file = Json::parse(oxturn("score " + file + " rooms:3 --json").out), by_pipe = Json::parse(named.out);
  by_file.erase("path");
  by_pipe.erase("path");
  EXPECT_EQ(by_file, by_pipe);
  EXPECT_EQ(oxturn("plan boustrophedon rooms:3 -o -").out, content(file));
  EXPECT_EQ(shell("oxturn score - rooms:3 --json <" + file).out, named.out);
}

TEST(Streams, StandardOutputCarriesTheFileAlone) {
  const Folder folder;
  const Said path = oxturn("plan zigzag rectangle -o -");
  EXPECT_EQ(path.code, 0);
  EXPECT_EQ(Json::parse(path.out).at("type"), "FeatureCollection");
  EXPECT_THAT(path.err, HasSubstr("outcome"));
  const Said picture = oxturn("plan zigzag rectangle --json --svg - -o " + (folder / "path.geojson"));
  EXPECT_THAT(picture.out, AllOf(HasSubstr("<svg"), testing::EndsWith("</svg>\n")));
  EXPECT_THAT(picture.err, HasSubstr("\"outcome\": \"ok\""));
  const Said trace = oxturn("score " + (folder / "path.geojson") + " rectangle --robot tether=30 --tether-trace -");
  EXPECT_EQ(trace.out.substr(0, 7), "path_m,");
  EXPECT_THAT(trace.err, HasSubstr("outcome"));
  const Said map = oxturn("map rectangle -o -");
  EXPECT_EQ(Json::parse(map.out).at("type"), "Feature");
  EXPECT_THAT(map.err, HasSubstr("m2 free"));
  EXPECT_EQ(folder.files(), 1u);
}

TEST(Streams, APathNamesTheSettingsOfItsMap) {
  const Folder folder;
  const std::string map = folder / "map.geojson", path = folder / "path.geojson";
  ASSERT_EQ(oxturn("map rooms:9,width=12,rooms=3 -o " + map).code, 0);
  const Json on_file = Json::parse(oxturn("plan zigzag " + map + " --json").out);
  const Json planned = Json::parse(oxturn("plan zigzag rooms:9,width=12,rooms=3 --json -o " + path).out);
  EXPECT_EQ(planned.at("metrics").at("path_m"), on_file.at("metrics").at("path_m"));
  const Json scored = Json::parse(oxturn("score " + path + " --json").out);
  EXPECT_EQ(scored.at("metrics").at("path_m"), on_file.at("metrics").at("path_m"));
}

TEST(Streams, MapsInEveryFormat) {
  const Folder folder;
  const std::string map = folder / "map.geojson";
  ASSERT_EQ(oxturn("map rooms:9 --seed 9 -o " + map).code, 2) << "the seed is given twice";
  ASSERT_EQ(oxturn("map rooms:9 -o " + map).code, 0);
  EXPECT_EQ(oxturn("map rooms --seed 9 -o - 2>/dev/null").out, content(map));
  EXPECT_EQ(shell("oxturn map - -o - <" + map).out, content(map));
  ASSERT_EQ(oxturn("map rooms:9 --set rooms=3 --set width=12 -o " + map).code, 0);
  EXPECT_EQ(oxturn("map rooms:9,width=12,rooms=3 -o - 2>/dev/null").out, content(map));
  EXPECT_EQ(oxturn("map rooms,width=12 --set rooms=3 --seed 9 -o - 2>/dev/null").out, content(map));
  ASSERT_EQ(oxturn("map " + map + " -o " + (folder / "map.svg")).code, 0);
  EXPECT_EQ(shell("oxturn map - --to svg -o - <" + map).out, content(folder / "map.svg"));
  const std::string image = OXTURN_SOURCE_DIR "/tests/data/ros/small.pgm";
  ASSERT_EQ(oxturn("map " + image + " --scale 0.1 -o " + (folder / "image.geojson")).code, 0);
  const Said converted = shell("oxturn map - --from image --scale 0.1 -o - <" + image);
  EXPECT_EQ(Json::parse(converted.out).at("geometry"), Json::parse(content(folder / "image.geojson")).at("geometry"));
  const Said planned = shell("oxturn plan zigzag - -o - <" + map + " | oxturn score - " + map);
  EXPECT_EQ(planned.code, 0) << planned.err;
  EXPECT_EQ(shell("oxturn map - --from text -o x.svg <" + map).code, 2);
  EXPECT_THAT(oxturn("map rooms --to ros -o -").err,
              HasSubstr("cannot write maps in the format 'ros', expected one of: geojson"));
}

TEST(Streams, ASuite) {
  const Folder folder;
  const std::string suite = folder.write("s.toml",
                                         "schema = 1\nname = \"s\"\n[robots.disc]\nradius = 0.2\ntool_width = 0.4\n"
                                         "[[maps]]\ngenerator = \"rectangle\"\n[[planners]]\nname = \"zigzag\"\n");
  const Said run = shell("oxturn run - -q --no-pictures -o " + (folder / "out") + " <" + suite);
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(shell("oxturn missing - " + (folder / "out") + " <" + suite).code, 0);
}

TEST(Streams, OneFileEach) {
  const auto refused = [](const std::string& arguments, const std::string& sentence) {
    const Said said = oxturn(arguments);
    EXPECT_EQ(said.code, 2) << arguments;
    EXPECT_EQ(said.out, "");
    EXPECT_EQ(said.err_lines(), 1) << said.err;
    EXPECT_THAT(said.err, HasSubstr(sentence));
  };
  const std::string output = "are both '-', standard output, which carries one file; name a file for one of them";
  refused("plan zigzag rectangle -o - --svg -", "--output and --svg " + output);
  refused("plan zigzag rectangle -o - --tether-trace -", "--output and --tether-trace " + output);
  refused("score x.csv rectangle --svg - --tether-trace -", "--svg and --tether-trace " + output);
  refused("score - -", "PATH and MAP are both '-', standard input");
  refused("score - rectangle", "- has 0 points");
  refused("plan zigzag -", "-:1: not JSON");
  refused("run - -o x", "-:1: the suite has no 'schema'");
}

}  // namespace
}  // namespace oxturn
