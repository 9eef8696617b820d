#include <fmt/format.h>
#include <gmock/gmock.h>

#include <map>

#include "base/files.hpp"
#include "base/text.hpp"
#include "geometry/overlay/boolean.hpp"
#include "maps/formats.hpp"
#include "maps/generators.hpp"
#include "tests/support/files.hpp"
#include "tests/support/maps.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;

MapFile read(const std::string& content, const Settings& settings = {}) {
  const TemporaryFolder folder;
  write_file(folder.file("lawn.poly"), content);
  return read_map(folder.file("lawn.poly"), settings, built_in_map_formats());
}

/// The error message, without the folder's name; empty if there is none.
std::string why(const std::string& content) {
  try {
    read(content);
  } catch (const std::invalid_argument& e) {
    const std::string text = e.what();
    EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    return text.substr(text.find("lawn.poly"));
  }
  return "";
}

const std::string kSquare = "4 0 0 4 0 4 4 0 4\n", kHole = "4 1 1 1 2 2 2 2 1\n";

TEST(PolygonFormat, ARingALine) {
  const Map map = read(kSquare + kHole).map;
  EXPECT_EQ(map.name, "lawn");
  EXPECT_DOUBLE_EQ(area(map.free), 16 - 1);
  EXPECT_EQ(hole_count(map.free), 1u);
  EXPECT_FALSE(map.target_area);
  for (const std::string& same : {kSquare + "1\n" + kHole,              // as CGAL writes it
                                  "\n" + kSquare + "\n\n" + kHole,      // empty lines
                                  "5 0 0 4 0 4 4 0 4 0 0\r\n" + kHole,  // closed, with carriage returns
                                  "4\t0 0  4 0 4 4 0 4e0\n" + kHole.substr(0, kHole.size() - 1)})
    EXPECT_EQ(content_hash(read(same).map), content_hash(read(kSquare + kHole).map)) << same;
}

TEST(PolygonFormat, WithFreeSpaceAroundItIsTheTargetArea) {
  const Map map = read(kSquare + kHole, {{"around", 1.5}}).map;
  EXPECT_DOUBLE_EQ(area(map.free), 7 * 7);
  EXPECT_EQ(hole_count(map.free), 0u);
  ASSERT_TRUE(map.target_area);
  EXPECT_DOUBLE_EQ(area(*map.target_area), 16 - 1);
  EXPECT_THROW(read(kSquare, {{"around", -1.0}}), std::invalid_argument);
}

/// The command line has one option for a name, whatever formats have it.
TEST(ReadMap, OptionsOfOneNameMeanTheSame) {
  std::map<std::string, std::string> help;
  for (const MapFormat& format : built_in_map_formats())
    for (const ParameterInfo& parameter : format.parameters)
      EXPECT_EQ(help.emplace(parameter.name, parameter.help).first->second, parameter.help) << format.name;
}

TEST(PolygonFormat, BadContentIsASentence) {
  EXPECT_EQ(why(""), "lawn.poly: no ring, expected a line with the number of vertices and their x y");
  EXPECT_EQ(why("4 0 0 4 0 4 4\n"),
            "lawn.poly:1: 6 numbers after the number of vertices, expected x and y of 4 vertices");
  EXPECT_EQ(why(kSquare + "4 1 1 1 2 2 2 2\n"),
            "lawn.poly:2: 7 numbers after the number of vertices, expected x and y of 4 vertices");
  EXPECT_EQ(why("4 0 0 4 0 4 4 0 x\n"), "lawn.poly:1: 'x', expected a coordinate in metres");
  EXPECT_EQ(why("4 0 0 4 0 4 4 0 nan\n"), "lawn.poly:1: 'nan', expected a coordinate in metres");
  EXPECT_EQ(why("four 0 0\n"), "lawn.poly:1: 'four', expected the number of vertices of a ring");
  EXPECT_EQ(why("-4 0 0 4 0 4 4 0 4\n"), "lawn.poly:1: '-4', expected the number of vertices of a ring");
  EXPECT_THAT(why("9223372036854775808\n"), HasSubstr("0 numbers after the number of vertices"));
  EXPECT_EQ(why("3 0 0 4 0 0 0\n"), "lawn.poly:1: 2 different vertices, expected at least 3");
  EXPECT_EQ(why(kSquare + "2\n" + kHole), "lawn.poly: 1 holes, expected 2 as the file says");
  EXPECT_THAT(why("4 0 0 4 4 4 0 0 4\n"), HasSubstr("lawn.poly"));  // edges that cross
  const std::string whole = kSquare + "1\n" + kHole;
  for (std::size_t cut = 0; cut < whole.size(); ++cut) why(whole.substr(0, cut));  // a map or a sentence
}

TEST(PolygonFormat, ReadsWhatIsWritten) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const char* kind = seed % 3 == 0 ? "polyomino" : seed % 3 == 1 ? "orthogonal" : "octagonal";
    const Map lawn = generate("polyomino", {{"kind", std::string(kind)}, {"squares", 40}, {"margin", 2.0}}, seed,
                              built_in_generators());
    std::string text;
    for_each_ring(*lawn.target_area, [&](const Ring& ring) {
      text += fmt::format("{}", ring.size());
      for (const Point& p : ring) text += " " + to_decimal(p.x()) + " " + to_decimal(p.y());
      text += "\n";
    });
    const Region again = *read(text, {{"around", 0.8}}).map.target_area;
    EXPECT_TRUE(subtract(again, *lawn.target_area).empty() && subtract(*lawn.target_area, again).empty()) << seed;
  }
}

}  // namespace
}  // namespace oxturn
