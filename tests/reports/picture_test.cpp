// The SVG: what is drawn where, told by reading the file as text.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "maps/formats.hpp"
#include "maps/formats/svg.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;
using testing::Not;

Problem box() { return Problem({"a <box>", box_region({0, 0}, {10, 5}), "file", "hand"}, Robot{}, Point(1, 1)); }

Path there_and_back() {
  PathBuilder builder({1, 1});
  builder.drive({9, 1}, true);
  builder.drive({9, 2}, false);
  builder.drive({1, 2}, true);
  return builder.take();
}

/// Attribute `name` of the first element that contains `where`.
double attribute(const std::string& svg, const std::string& where, const std::string& name) {
  std::smatch found;
  const std::string from = svg.substr(svg.find(where));
  if (!std::regex_search(from, found, std::regex(" " + name + "=\"([-0-9.]+)\""))) return NAN;
  return std::stod(found[1]);
}

TEST(Picture, HasEveryLayer) {
  const Path path = there_and_back();
  const std::string svg = to_svg(box(), &path);
  for (const char* id : {"free", "target", "swath", "transit", "path", "start", "end", "scale"})
    EXPECT_THAT(svg, HasSubstr("id=\"" + std::string(id) + "\"")) << id;
  EXPECT_THAT(svg, HasSubstr("<title>a &lt;box&gt;</title>"));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

// A metre is as many pixels across as up; y points up: the start is below the end.
TEST(Picture, IsToScaleAndUpright) {
  const Path path = there_and_back();
  const std::string svg = to_svg(box(), &path);
  const double scale = (1000 - 24) / 10.0;
  EXPECT_NEAR(attribute(svg, "<g id=\"start\"", "cx"), 12 + 1 * scale, 0.01);
  EXPECT_NEAR(attribute(svg, "<g id=\"start\"", "cy"), 12 + 4 * scale, 0.01);
  EXPECT_LT(attribute(svg, "<rect id=\"end\"", "y"), attribute(svg, "<g id=\"start\"", "cy"));
  EXPECT_NEAR(attribute(svg, "id=\"swath\"", "stroke-width"), 0.4 * scale, 0.01);
}

TEST(Picture, LongPathsAreFewPieces) {
  PathBuilder builder({1, 1});
  for (int i = 1; i < 60000; ++i) builder.drive({1 + 8 * (i % 2), 1 + 3 * i / 60000.0}, true);
  const Path path = builder.take();
  const std::string svg = to_svg(box(), &path);
  std::size_t pieces = 0;
  for (std::size_t at = svg.find("<path stroke="); at != std::string::npos; at = svg.find("<path stroke=", at + 1))
    ++pieces;
  EXPECT_GT(pieces, 400u);
  EXPECT_LE(pieces, 500u);
}

TEST(Picture, APathThatIsNotFiniteIsDrawnUpToThere) {
  const Path path{{{true, {{1, 1}, {2, 1}, {NAN, 1}, {3, 1}}}}};
  const std::string svg = to_svg(box(), &path);
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, HasSubstr("id=\"end\""));
  EXPECT_THAT(to_svg(box(), nullptr), Not(HasSubstr("id=\"path\"")));
}

TEST(Picture, ABareMapHasNoStart) {
  const std::string svg = to_svg(Map{"m", box_region({0, 0}, {1, 9}), "file", ""});
  EXPECT_THAT(svg, HasSubstr("id=\"free\""));
  EXPECT_THAT(svg, Not(HasSubstr("id=\"start\"")));
}

}  // namespace
}  // namespace oxturn
