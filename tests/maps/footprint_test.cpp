// Robots that are not discs: which footprints are valid, how files give them, and where such a robot fits.
#include <gmock/gmock.h>

#include "base/files.hpp"
#include "maps/formats.hpp"
#include "maps/locations.hpp"
#include "maps/path_file.hpp"
#include "maps/problem.hpp"
#include "tests/support/files.hpp"
#include "tests/support/maps.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;

Robot shaped(Ring footprint) {
  Robot robot;
  robot.name = "r";
  robot.footprint = std::move(footprint);
  return robot;
}
std::string flaw_of(const Robot& robot) {
  return complaint([&] { check(robot); });
}
Map hall() { return {"hall", box_region({0, 0}, {10, 8}), "test", ""}; }

TEST(Footprint, NamedShapes) {
  const Ring octagon = parse_footprint("octagon:1");
  ASSERT_EQ(octagon.size(), 8u);
  EXPECT_EQ(flaw_of(shaped(octagon)), "");
  EXPECT_NEAR(in_radius(octagon), 0.5, 1e-12);
  EXPECT_NEAR(signed_area(octagon), 2 * (std::sqrt(2.0) - 1), 1e-12);  // of width 1
  EXPECT_DOUBLE_EQ(height(shaped(octagon)), 1);
  EXPECT_EQ(parse_footprint("square:0.5"), (Ring{{.25, -.25}, {.25, .25}, {-.25, .25}, {-.25, -.25}}));
  for (const char* bad : {"octagon", "octagon:", "octagon:-1", "octagon:0", "octagon:1m", "octagon:inf", "star:1", ""})
    EXPECT_THAT(complaint([&] { parse_footprint(bad); }), HasSubstr("expected disc, square:WIDTH or octagon:WIDTH"))
        << bad;
}

TEST(Footprint, EachFlawIsOneSentence) {
  EXPECT_EQ(flaw_of(shaped({{1, 0}, {0, 1}})), "robot 'r': footprint has 2 vertices, expected at least 3");
  EXPECT_THAT(flaw_of(shaped({{1, 0}, {0, std::nan("")}, {-1, -1}})), HasSubstr("vertex 2 is not finite"));
  EXPECT_THAT(flaw_of(shaped({{1, 0}, {-1, -1}, {0, 1}})), HasSubstr("runs clockwise"));
  EXPECT_THAT(flaw_of(shaped({{1, -1}, {1, 1}, {0, 0.2}, {-1, 1}, {-1, -1}})), HasSubstr("not convex at vertex 3"));
  EXPECT_THAT(flaw_of(shaped({{1, -1}, {1, 0}, {1, 1}, {-1, 1}, {-1, -1}})), HasSubstr("not convex at vertex 2"));
  EXPECT_THAT(flaw_of(shaped({{2, 0}, {3, 0}, {3, 1}})), HasSubstr("does not hold the robot's centre"));
  EXPECT_THAT(flaw_of(shaped({{0, 0}, {1, 0}, {0, 1}})), HasSubstr("does not hold the robot's centre"));
  Ring star;  // five points, winding number 2
  for (int k = 0; k < 5; ++k) star.push_back(rotated({1, 0}, 4 * kPi * k / 5));
  EXPECT_THAT(flaw_of(shaped(star)), HasSubstr("more than once"));
  Robot leashed = shaped(parse_footprint("square:1"));
  leashed.tether = Tether{5};
  EXPECT_THAT(flaw_of(leashed), HasSubstr("a tether needs a round robot"));
  Robot turning = shaped(parse_footprint("square:1"));
  turning.min_turn_radius = 1;
  EXPECT_THAT(flaw_of(turning), HasSubstr("never turns"));
}

TEST(Footprint, ConfigurationSpaceAndTarget) {
  const Problem p(hall(), shaped({{0.5, -0.25}, {0.5, 0.25}, {-1, 0.25}, {-1, -0.25}}), Point(5, 4));
  const Box box = bounding_box(p.configuration_space());
  EXPECT_NEAR(box.low.x(), 1, 1e-6);
  EXPECT_NEAR(box.high.x(), 9.5, 1e-6);
  EXPECT_NEAR(box.low.y(), 0.25, 1e-6);
  EXPECT_NEAR(box.high.y(), 7.75, 1e-6);
  EXPECT_EQ(p.robot().radius, 0.25);  // the largest disc inside
  EXPECT_THAT(complaint([&] { Problem(hall(), shaped(parse_footprint("square:9"))); }),
              HasSubstr("robot 'r' (footprint of 4 vertices) fits nowhere"));
  EXPECT_THAT(complaint([&] { Problem(hall(), p.robot(), Point(0.5, 4)); }), HasSubstr("too near a wall"));
}

TEST(Footprint, ChangesTheHash) {
  const Point at(5, 4);
  Robot disc;
  disc.radius = 0.5;
  const std::string round = Problem(hall(), disc, at).content_hash();
  const std::string octagon = Problem(hall(), shaped(parse_footprint("octagon:1")), at).content_hash();
  const std::string square = Problem(hall(), shaped(parse_footprint("square:1")), at).content_hash();
  EXPECT_NE(round, octagon);
  EXPECT_NE(square, octagon);
}

TEST(Footprint, ACornerStartKeepsAMargin) {
  const Robot robot = shaped({{0.5, -0.25}, {0.5, 0.25}, {-1, 0.25}, {-1, -0.25}});
  const StartAndAnchor resolved = resolve(hall(), robot, Location{"corner", {0, 0}}, {});
  ASSERT_TRUE(resolved.start);
  EXPECT_GE(resolved.start->x(), 1.004);
  EXPECT_GE(resolved.start->y(), 0.254);
  EXPECT_LT(resolved.start->norm(), 1.1);
}

TEST(Footprint, GeoJsonThereAndBack) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& robot) {
    const std::string file = folder.file("m.geojson");
    write_file(file, R"({"type":"Feature","properties":{"robot":)" + robot +
                         R"(},"geometry":{"type":"Polygon","coordinates":[[[0,0],[9,0],[9,9],[0,9]]]}})");
    return read_map(file, {});
  };
  const MapFile named = read(R"({"footprint":"octagon:1.5","tool_width":1})");
  ASSERT_TRUE(named.robot);
  EXPECT_EQ(named.robot->footprint, parse_footprint("octagon:1.5"));
  const MapFile listed = read(R"({"footprint":[[1,0],[0,1],[-1,-1]]})");
  EXPECT_EQ(listed.robot->footprint, (Ring{{1, 0}, {0, 1}, {-1, -1}}));
  const Problem p(listed.map, *listed.robot);
  write_file(folder.file("back.geojson"), to_geojson(p));
  const MapFile back = read_map(folder.file("back.geojson"), {});
  EXPECT_EQ(back.robot->footprint, listed.robot->footprint);
  EXPECT_EQ(Problem(back.map, *back.robot, back.start, back.anchor).content_hash(), p.content_hash());

  EXPECT_THAT(complaint([&] { read(R"({"footprint":"octagon:1","radius":1})"); }),
              HasSubstr("a radius and a footprint, expected one of the two"));
  EXPECT_THAT(complaint([&] { read(R"({"footprint":3})"); }),
              HasSubstr("'footprint' of robot 'disc' is 3, expected a text"));
  EXPECT_THAT(complaint([&] { read(R"({"footprint":[]})"); }), HasSubstr("footprint is '', expected disc"));
  EXPECT_THAT(complaint([&] { read(R"({"footprint":[[1,0],[0,"x"],[0,0]]})"); }), HasSubstr("footprint, point 2"));
  EXPECT_THAT(complaint([&] { read(R"({"footprint":"star:1"})"); }), HasSubstr("footprint is 'star:1'"));
}

}  // namespace
}  // namespace oxturn
