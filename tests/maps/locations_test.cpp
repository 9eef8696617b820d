// Locations by name, against scans of sampled points.
#include "maps/locations.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/edge_index.hpp"
#include "maps/generators.hpp"
#include "maps/problem.hpp"
#include "tests/support/drawn.hpp"
#include "tests/support/files.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;

Location at(double x, double y) { return {"", {x, y}}; }

TEST(StartAndAnchor, NamesAndCoordinates) {
  EXPECT_EQ(parse_location(LocationKind::start, "corner").name, "corner");
  EXPECT_EQ(parse_location(LocationKind::anchor, "wall").name, "wall");
  EXPECT_EQ(parse_location(LocationKind::anchor, "-1.5,+2"), at(-1.5, 2));
  EXPECT_EQ(to_text(at(-1.5, 2)), "-1.5 2");
  EXPECT_EQ(to_text(parse_location(LocationKind::anchor, "start")), "start");
}

TEST(StartAndAnchor, MistakesAreOneSentence) {
  for (const std::string text : {"wall", "", "1", "1,", ",", "1,2,3", "1, 2", "inf,1", "nan,0", "Corner"})
    EXPECT_EQ(
        complaint([&] { parse_location(LocationKind::start, text); }),
        fmt::format("start is '{}', expected X,Y: two finite numbers in metres, or one of: middle, corner", text));
  EXPECT_THAT(complaint([] { parse_location(LocationKind::anchor, "middle"); }),
              HasSubstr("one of: start, wall, corner"));
}

TEST(StartAndAnchor, NotGivenIsEmpty) {
  const Map map = generate("rooms", {}, 1);
  const StartAndAnchor resolved = resolve(map, Robot{}, {}, {});
  EXPECT_FALSE(resolved.start);
  EXPECT_FALSE(resolved.anchor);
  const StartAndAnchor given = resolve(map, Robot{}, at(1, 2), at(3, 4));
  EXPECT_EQ(given.start, Point(1, 2));
  EXPECT_EQ(given.anchor, Point(3, 4));
}

TEST(StartAndAnchor, ByHand) {
  const Map map{"drawn", drawn_region({"######", "#....#", "#....#", "#.##.#", "######"}), "drawn", ""};
  const StartAndAnchor resolved = resolve(map, Robot{}, Location{"corner"}, Location{"wall"});
  // Free space begins at (1, 1); the robot's radius is 0.2, a hundredth of its tool 0.004.
  EXPECT_NEAR(distance(*resolved.start, {1.204, 1.204}), 0, 1e-3);
  EXPECT_NEAR(distance(*resolved.start, *resolved.anchor), 0.204, 1e-3);
  EXPECT_EQ(resolve(map, Robot{}, at(2.6, 2.5), Location{"wall"}).anchor, Point(2.6, 2));
  EXPECT_EQ(resolve(map, Robot{}, at(2.6, 2.5), Location{"corner"}).anchor, Point(2, 2));
  EXPECT_EQ(resolve(map, Robot{}, at(2.6, 2.5), Location{"start"}).anchor, Point(2.6, 2.5));
  EXPECT_EQ(resolve(map, Robot{}, {}, Location{"start"}).start, default_start(map, Robot{}));
}

// The corner in the next room is nearer, but behind a wall.
TEST(StartAndAnchor, AnInvisibleCornerIsNoAnchor) {
  const Region region = drawn_region({"#######", "#.....#", "#.....#", "#.....#", "#.###.#", "#.#...#", "#######"}, 1);
  const Map map{"drawn", region, "drawn", ""};
  // The small room's upper left corner (3, 2) is 1.2 m from the start, those of the large room 1.5 m.
  const StartAndAnchor resolved = resolve(map, Robot{}, at(3.5, 3.1), Location{"corner"});
  EXPECT_TRUE(EdgeIndex(region).contains(*resolved.start, *resolved.anchor));
  EXPECT_EQ(resolved.anchor, Point(2, 3));
}

TEST(StartAndAnchor, AreWhereTheHeaderSays) {
  for (const std::string family : {"clutter", "cave", "rooms", "berg-rooms", "polygon"})
    for (const std::uint64_t seed : seeds(6)) {
      SCOPED_TRACE(fmt::format("{} --seed {}", family, seed));
      const Map map =
          generate(family, {{"width", 10.0}, {"height", 8.0}, {"rotation", 10.0 * static_cast<double>(seed)}}, seed);
      Robot robot;
      robot.tether = Tether{3};
      const StartAndAnchor resolved = resolve(map, robot, Location{"corner"}, Location{"wall"});
      const EdgeIndex walls(map.free);
      EXPECT_TRUE(walls.contains(*resolved.anchor));
      Robot fat;
      fat.radius = 0.204;
      const Problem loose(map, fat, resolved.start);
      const Point &start = *resolved.start, &anchor = *resolved.anchor;
      // No sampled point of configuration space is farther to the lower left, no wall nearer.
      for_each_ring(loose.configuration_space(), [&](const Ring& ring) {
        for (const Point& p : ring) EXPECT_GE(p.x() + p.y(), start.x() + start.y());
      });
      double nearest = 1e9, corner = 1e9;
      for_each_ring(map.free, [&](const Ring& ring) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
          for (int k = 0; k < 200; ++k) nearest = std::min(nearest, distance(start, lerp(a, b, k / 200.0)));
          if (walls.contains(start, a)) corner = std::min(corner, distance(start, a));
        }
      });
      EXPECT_LE(distance(start, anchor), nearest + 1e-12);
      EXPECT_LT(walls.nearest(anchor)->distance, 1e-12);
      const StartAndAnchor other = resolve(map, robot, at(start.x(), start.y()), Location{"corner"});
      EXPECT_EQ(distance(start, *other.anchor), corner);
    }
}

}  // namespace
}  // namespace oxturn
