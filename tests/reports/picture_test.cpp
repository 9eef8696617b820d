// The SVG: what is drawn where, told by reading the file as text.
#include "maps/picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "geometry/trace.hpp"
#include "maps/formats.hpp"

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

TEST(Picture, ShowsWhereTheRobotDrivesBackwards) {
  Path path = there_and_back();
  EXPECT_THAT(to_svg(box(), &path), Not(HasSubstr("id=\"reverse\"")));
  path.legs.back().gear = Gear::reverse;
  EXPECT_THAT(to_svg(box(), &path), HasSubstr("id=\"reverse\""));
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

std::size_t count(const std::string& svg, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = svg.find(what); at != std::string::npos; at = svg.find(what, at + 1)) ++n;
  return n;
}

/// Round a pillar from (4, 4) to (6, 6).
Problem tethered_box() {
  Region room = box_region({0, 0}, {10, 10});
  room.polygons[0].holes.push_back({{4, 4}, {4, 6}, {6, 6}, {6, 4}});
  Robot robot;
  robot.tether = Tether{30};
  return Problem({"leashed", room, "file", "hand"}, robot, Point(3, 3), Point(2, 3));
}

TEST(Picture, TetherAtChosenMoments) {
  PathBuilder builder({3, 3});
  for (const Point& p : {Point(7, 3), Point(7, 7), Point(3, 7), Point(7, 7)}) builder.drive(p, true);
  const Path path = builder.take();
  const Problem problem = tethered_box();
  const std::string svg = to_svg(problem, &path);
  EXPECT_THAT(svg, HasSubstr("id=\"anchor\""));
  EXPECT_EQ(count(svg, " m of tether after "), 8u) << "the longest, at (3, 7), is one of the eight";
  EXPECT_EQ(count(svg, "of tether after 12 m: the longest"), 1u);
  // After 2, 4 metres straight; 6: about (6, 4); 8: the same; 10, 12: also (6, 6); 14, 16: as 10 and 8.
  EXPECT_EQ(count(svg, "class=\"bend\""), 1u + 1 + 2 + 2 + 2 + 1);
  PictureOptions options;
  options.tethers = 3;
  EXPECT_EQ(count(to_svg(problem, &path, options), " m of tether after "), 4u) << "and the longest";
  options.tethers = 0;
  EXPECT_EQ(count(to_svg(problem, &path, options), " m of tether after "), 0u);
  EXPECT_THAT(to_svg(problem, nullptr), HasSubstr("id=\"anchor\""));
  EXPECT_THAT(to_svg(box(), &path), Not(HasSubstr("id=\"anchor\"")));
}

TEST(Picture, TetherIsDrawnUpToWhereItCanFollow) {
  const Path path{{{true, {{3, 3}, {7, 3}, {5, 5}, {7, 3}}}}};
  const std::string svg = to_svg(tethered_box(), &path);
  EXPECT_THAT(svg, HasSubstr("after 4 m: the longest"));
}

TEST(Picture, TracesHaveColoursByName) {
  const std::vector<Trace> traces{{"a", {{{1, 1}, {2, 2}}}}, {"b", {{{1, 1}, {2, 2}}}}, {"a", {{{1, 2}, {2, 3}}}}};
  PictureOptions options;
  options.traces = &traces;
  const std::string svg = to_svg(box(), nullptr, options);
  const auto colour = [&](const std::string& from) {
    const std::size_t at = svg.find("stroke=\"", svg.find(from)) + 8;
    return svg.substr(at, 7);
  };
  EXPECT_NE(colour("<g id=\"a\""), colour("<g id=\"b\""));
  EXPECT_EQ(count(svg, "<g id=\"a\" fill=\"none\" stroke=\"" + colour("<g id=\"a\"")), 2u);
}

}  // namespace
}  // namespace oxturn
