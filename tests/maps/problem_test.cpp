#include "maps/problem.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <thread>

#include "base/random.hpp"
#include "geometry/overlay/boolean.hpp"
#include "tests/support/drawn.hpp"
#include "tests/support/files.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using testing::HasSubstr;

Robot disc(double radius, double tool) {
  Robot r;
  r.radius = radius;
  r.tool_width = tool;
  return r;
}

Map square(double side, Point low = {0, 0}) { return {"square", box_region(low, low + Point(side, side)), "test", ""}; }

/// Least distance from p to any wall, by a scan of all edges.
double distance_to_walls(const Region& free, const Point& p) {
  double least = 1e300;
  for_each_ring(free, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      least = std::min(least, distance_to_segment(p, ring[i], ring[(i + 1) % ring.size()]));
  });
  return least;
}

std::vector<std::string> random_rows(std::uint64_t seed, int n) {
  Rng rng(seed);
  std::vector<std::string> rows(static_cast<std::size_t>(n), std::string(static_cast<std::size_t>(n), '.'));
  for (std::string& row : rows)
    for (char& c : row) c = rng.chance(0.3) ? '#' : '.';
  return rows;
}

/// The target's area against a closed form.
void expect_target(const Problem& p, double truth) {
  EXPECT_LE(area(p.target()), truth * (1 + 1e-12));
  EXPECT_GE(area(p.target()) + p.target_excess(), truth * (1 - 1e-12));
  EXPECT_LT(p.target_excess(), 1e-4 * truth);
  EXPECT_GE(p.target_excess(), 0);
}

Map with_target(Map map, Region target) {
  map.target_area = std::move(target);
  return map;
}

TEST(TargetArea, IsWhatTheTargetLiesIn) {
  const Map map = with_target(square(10), box_region({-1, 4}, {2, 7}));  // a part of it lies outside of the map
  const Problem p(map, disc(0.5, 1), Point(8, 8));
  EXPECT_NEAR(area(p.target()), 2 * 3, 1e-5);
  EXPECT_NEAR(area(p.configuration_space()), 81, 1e-4);
  EXPECT_NEAR(area(p.work_space()), 1.5 * 3 + 2 * 1.5 * 0.5 + 0.5 * 3 + 0.5 * kPi * 0.25, 2e-3);
  for (std::uint64_t i = 0; i < 500; ++i) {
    Rng rng(i);
    const Point q(rng.between(0.6, 3.0), rng.between(3.0, 8.0));
    const double away = distance(q, Point(std::min(q.x(), 2.0), std::clamp(q.y(), 4.0, 7.0)));
    if (std::abs(away - 0.5) > 2e-3) { EXPECT_EQ(contains(p.work_space(), q), away < 0.5) << q.transpose(); }
  }
}

TEST(TargetArea, HoldsTheStartByDefault) {
  const auto start = [](Map map) {
    const Problem p(map, disc(0.5, 1));
    EXPECT_EQ(p.start(), default_start(map, disc(0.5, 1)));
    return p.start();
  };
  const Region block = box_region({1, 7}, {3, 9}), at_wall = box_region({9.7, 2}, {10, 3});
  EXPECT_TRUE(contains(block, start(with_target(square(10), block))));
  // The robot does not fit there, its tool does.
  EXPECT_GE(start(with_target(square(10), at_wall)).x(), 9.7 - 0.5);
  // In a room that is not the largest one, and has no door.
  Map two = square(10);
  two.free.polygons.push_back(square(4, {12, 0}).free.polygons.front());
  EXPECT_GT(start(with_target(two, box_region({12, 1}, {14, 2}))).x(), 12);
  // What a drawing marks is thin lines: the middle of the canvas does.
  Map drawn = with_target(square(10), block);
  drawn.drawing = std::make_shared<const Drawing>();
  EXPECT_EQ(start(drawn), start(square(10)));
}

TEST(TargetArea, EntersTheHash) {
  const Map whole = square(10), block = with_target(whole, box_region({1, 1}, {2, 2}));
  EXPECT_NE(content_hash(whole), content_hash(block));
  EXPECT_NE(content_hash(with_target(whole, box_region({1, 1}, {2, 3}))), content_hash(block));
  EXPECT_NE(Problem(whole, disc(0.5, 1), Point(5, 5)).content_hash(),
            Problem(block, disc(0.5, 1), Point(5, 5)).content_hash());
}

TEST(TargetArea, OutOfReachIsASentence) {
  const auto refusal = [](Map map, const Robot& robot) -> std::string {
    try {
      Problem(std::move(map), robot, Point(1, 1));
    } catch (const std::invalid_argument& e) { return e.what(); }
    return "";
  };
  EXPECT_THAT(refusal(with_target(square(4), box_region({5, 5}, {6, 6})), disc(0.5, 1)),
              HasSubstr("target area of map 'square' lies outside its free space, near (5.5, 5.5)"));
  EXPECT_THAT(refusal(with_target(square(4), Region{}), disc(0.5, 1)), HasSubstr("has no area"));
  Map two = square(4);  // a second room without a door
  two.free.polygons.push_back(square(4, {6, 0}).free.polygons.front());
  EXPECT_THAT(refusal(with_target(two, box_region({7, 1}, {8, 2})), disc(0.5, 1)),
              HasSubstr("target area of map 'square' is out of reach: robot"));
}

TEST(Problem, SquareByHand) {
  const Problem p(square(10), disc(0.5, 1), Point(5, 5));
  EXPECT_NEAR(area(p.configuration_space()), 81, 1e-4);
  expect_target(p, area(p.configuration_space()) + 36 * 0.5 + kPi * 0.25);  // Steiner's formula, 9 x 9 and r = 0.5
}

TEST(Problem, ToolWiderThanTheRobotStopsAtWalls) {
  const Problem p(square(10), disc(0.5, 2), Point(5, 5));
  EXPECT_LE(area(p.target()), 100);
  EXPECT_GE(area(p.target()) + p.target_excess(), 100 - 1e-6);  // the corners lie 0.71 from (0.5, 0.5): reached
}

TEST(Problem, ToolsWiderThanTheMapReachAllOfIt) {
  for (const double tool : {2.0, 20.0, 1e3, 1e9}) {
    SCOPED_TRACE(tool);
    expect_target(Problem(square(10), disc(0.5, tool), Point(5, 5)), 100);
    expect_target(Problem(with_target(square(10), box_region({8, 8}, {12, 12})), disc(0.5, tool), Point(5, 5)), 4);
  }
}

TEST(Problem, ANarrowToolLeavesTheBoundaryUncovered) {
  const Problem p(square(10), disc(0.5, 0.5), Point(5, 5));
  const Box box = bounding_box(p.configuration_space());
  const Point s = box.size();
  expect_target(p, s.x() * s.y() + 2 * (s.x() + s.y()) * 0.25 + kPi / 16);
}

TEST(Problem, RadiusZeroIsTheMapItself) {
  const Problem p(square(10), disc(0, 1), Point(0, 0));
  EXPECT_DOUBLE_EQ(area(p.configuration_space()), 100);
  EXPECT_DOUBLE_EQ(area(p.target()), 100);
}

// A room inside an obstacle is free space too, and a valid location for a start.
TEST(Problem, RoomsInsideObstaclesStay) {
  const std::vector<std::string> rows{".....", ".###.", ".#S#.", ".###.", "....."};
  const Problem p = drawn(rows);
  EXPECT_DOUBLE_EQ(area(p.map().free), 17);
  EXPECT_NEAR(area(p.configuration_space()), 0.36, 1e-6);
}

// Oracle: distance to all walls by brute force, and only the start's connected component.
TEST(Problem, ConfigurationSpaceKeepsItsDistance) {
  for (const auto seed : seeds(12)) {
    SCOPED_TRACE(seed);
    const auto rows = random_rows(seed, 12);
    const double radius = 0.17 + 0.02 * static_cast<double>(seed);
    const Problem p = drawn(rows, {.robot = disc(radius, 0.4)});
    ASSERT_EQ(p.configuration_space().polygons.size(), 1u);
    for_each_ring(p.configuration_space(), [&](const Ring& ring) {
      for (std::size_t i = 0; i < ring.size(); ++i) {
        EXPECT_GE(distance_to_walls(p.map().free, ring[i]), radius - 1e-9);
        EXPECT_GE(distance_to_walls(p.map().free, (ring[i] + ring[(i + 1) % ring.size()]) / 2), radius - 1e-9);
      }
    });
    // Nothing is missing: from a point inside, a short step that keeps off walls stays inside.
    Rng rng(seed);
    const Box box = bounding_box(p.configuration_space());
    int inside = 0;
    for (int k = 0; k < 1500; ++k) {
      const Point a(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
      const Point b = a + Point(rng.between(-0.3, 0.3), rng.between(-0.3, 0.3));
      if (!p.walls().contains(a)) continue;
      ++inside;
      bool clear = contains(p.map().free, b);
      for (int t = 0; clear && t <= 20; ++t)
        clear = distance_to_walls(p.map().free, lerp(a, b, t / 20.0)) > radius + 0.4 / 1000 + 0.01;
      if (clear) { EXPECT_TRUE(p.walls().contains(b)); }
    }
    EXPECT_GT(inside, 20);
  }
}

// Oracle: a point is in the target if it is free and a disc of radius w/2 about it meets configuration space.
TEST(Problem, TargetIsWhatTheToolReaches) {
  for (const auto seed : seeds(8)) {
    SCOPED_TRACE(seed);
    const double tool = seed % 2 == 0 ? 0.3 : 0.9;
    const Problem p = drawn(random_rows(seed, 10), {.robot = disc(0.3, tool)});
    const EdgeIndex target(p.target());
    Rng rng(seed);
    int in = 0, out = 0;
    for (int k = 0; k < 3000; ++k) {
      const Point q(rng.between(0.0, 10.0), rng.between(0.0, 10.0));
      const double reach = contains(p.configuration_space(), q) ? 0 : distance_to_walls(p.configuration_space(), q);
      const bool free = contains(p.map().free, q);
      if (target.contains(q)) {
        ++in;
        EXPECT_TRUE(free || distance_to_walls(p.map().free, q) < 1e-7);
        EXPECT_LE(reach, tool / 2 + 1e-9);
      } else if (free && distance_to_walls(p.map().free, q) > 1e-6) {
        ++out;
        EXPECT_GE(reach, tool / 2 - tool / 1000 - 1e-7);
      }
    }
    EXPECT_GT(in, 100);
    if (tool / 2 < 0.3) { EXPECT_GT(out, 10); }  // the wide tool may reach every corner
  }
}

TEST(Problem, PassagesOpenAndCloseWhereTheHeaderSays) {
  // Two rooms of 4 x 4, connected by a passage of the given width, 1 long.
  const auto rooms = [](double passage) {
    const double low = 2 - passage / 2, high = 2 + passage / 2;
    Region r;
    r.polygons.push_back(
        {{{0, 0}, {4, 0}, {4, low}, {5, low}, {5, 0}, {9, 0}, {9, 4}, {5, 4}, {5, high}, {4, high}, {4, 4}, {0, 4}},
         {}});
    return Map{"passage", r, "test", ""};
  };
  const double radius = 0.3, tool = 0.5, open = 2 * radius + tool / 500;
  const Problem through(rooms(open * 1.001), disc(radius, tool), Point(2, 2));
  EXPECT_TRUE(through.walls().contains(Point(7, 2)));
  EXPECT_TRUE(through.transit().path({2, 2}, {7, 2}).has_value());
  const Problem left(rooms(2 * radius * 0.999), disc(radius, tool), Point(2, 2));
  EXPECT_FALSE(left.walls().contains(Point(7, 2)));
  EXPECT_FALSE(left.transit().path({2, 2}, {7, 2}).has_value());
  const Problem right(rooms(2 * radius * 0.999), disc(radius, tool), Point(7, 2));
  EXPECT_TRUE(right.walls().contains(Point(7, 2)));
  EXPECT_NEAR(area(left.configuration_space()), area(right.configuration_space()), 1e-4);
  EXPECT_LT(area(left.target()), 0.51 * area(through.target()));
}

TEST(Problem, StartOnTheBoundaryCounts) {
  const Problem middle(square(10), disc(0.5, 1), Point(5, 5));
  const Point corner = middle.configuration_space().polygons[0].outer[0];
  EXPECT_EQ(Problem(square(10), disc(0.5, 1), corner).start(), corner);
  const Point beyond = corner + (corner - Point(5, 5)).normalized() * 0.4 * middle.tolerance();
  EXPECT_EQ(Problem(square(10), disc(0.5, 1), beyond).start(), beyond);
  const Point too_far = corner + (corner - Point(5, 5)).normalized() * 3 * middle.tolerance();
  EXPECT_THROW(Problem(square(10), disc(0.5, 1), too_far), std::invalid_argument);
}

TEST(Problem, StartInAWallIsOneSentenceWithAPointThatFits) {
  const std::vector<std::string> rows{"#####", "#...#", "#.#.#", "#...#", "#####"};
  const auto point_for = [&](Point start) -> Point {
    const std::string text = complaint([&] { drawn(rows, {.start = start}); });
    const std::size_t open = text.rfind('(');
    EXPECT_NE(open, std::string::npos) << text;
    Point p{0, 0};
    EXPECT_EQ(std::sscanf(text.c_str() + open, "(%lf, %lf)", &p.x(), &p.y()), 2) << text;
    return p;
  };
  EXPECT_THAT(
      complaint([&] { drawn(rows, {.start = Point(2.5, 2.25)}); }),
      HasSubstr("start (2.5, 2.25) is inside a wall of 'drawn'; nearest point where the robot fits: (2.5, 1.79"));
  EXPECT_THAT(complaint([&] { drawn(rows, {.start = Point(1.1, 1.1)}); }),
              HasSubstr("start (1.1, 1.1) is too near a wall of 'drawn' for robot 'disc' (radius 0.2)"));
  Rng rng(3);
  for (int k = 0; k < 60; ++k) {
    const Point start(rng.between(-3.0, 8.0), rng.between(-3.0, 8.0));
    const Problem middle = drawn(rows, {.start = Point(1.5, 1.5)});
    if (middle.walls().contains(start)) continue;
    const Point point = point_for(start);
    EXPECT_NO_THROW(drawn(rows, {.start = point}));
    EXPECT_LE(distance(point, start), distance_to_walls(middle.configuration_space(), start) + 0.02);
  }
}

TEST(Problem, HostileInputIsOneSentence) {
  const auto why = [](Map map, Robot robot, std::optional<Point> start = {}, std::optional<Point> anchor = {}) {
    const std::string text = complaint([&] { Problem(map, robot, start, anchor); });
    EXPECT_EQ(text.find('\n'), std::string::npos);
    return text;
  };
  const Map crossed{"bow", {{{{{0, 0}, {2, 4}, {4, 0}, {0, 2}}, {}}}}, "test", ""};
  EXPECT_THAT(why(crossed, disc(0.1, 0.2)), HasSubstr("map 'bow': edges cross at ("));
  const Map nan{"nan", {{{{{0, 0}, {4, 0}, {4, std::nan("")}}, {}}}}, "test", ""};
  EXPECT_THAT(why(nan, disc(0.1, 0.2)), HasSubstr("map 'nan': "));
  EXPECT_EQ(why({"void", {}, "test", ""}, disc(0.1, 0.2)), "map 'void' has no free space at all");
  EXPECT_EQ(
      why(square(1), disc(0.5, 1)),
      "robot 'disc' (radius 0.5) fits nowhere in map 'square', whose free space is 1 x 1 m; take a smaller robot, "
      "or check the map's scale");
  EXPECT_EQ(why(square(1), disc(0.1, 0)),
            "parameter 'tool_width' of robot 'disc' is 0, expected a number above 0, at most 1e+09");
  EXPECT_EQ(why(square(4), disc(0.1, 1), Point(std::nan(""), 1)), "start (nan, 1) is not finite, expected metres");
  EXPECT_EQ(why(square(4), disc(0.1, 1), Point(1, 1), Point(1, INFINITY)),
            "anchor (1, inf) is not finite, expected metres");
  EXPECT_EQ(why(square(4), disc(0.1, 1), Point(1, 1), Point(9, 1)),
            "anchor (9, 1) is inside a wall of 'square', expected a point in free space");
}

TEST(Problem, DefaultStartIsInsideTheLargestRoom) {
  const std::vector<std::string> rows{"#########", "#..#....#", "#..#....#", "####....#", "#########"};
  const Problem p = drawn(rows);
  EXPECT_GT(p.start().x(), 4);
  EXPECT_TRUE(p.walls().contains(p.start()));
  EXPECT_GT(distance_to_walls(p.configuration_space(), p.start()), 0.1);
  EXPECT_EQ(p.start(), default_start(p.map(), p.robot()));
  EXPECT_EQ(p.anchor(), p.start());
}

// The hall has the widest circle, but the corridor more area. In the closet no triangle of free space has its centre
// where the robot fits.
TEST(Problem, DefaultStartIsInTheLargestComponentWhateverIsWider) {
  const Region hall = box_region({0, 0}, {4, 4}), corridor = box_region({5, 0}, {45, 1});
  const Map both{"both", unite({hall, corridor}), "", ""};
  EXPECT_GT(default_start(both, disc(0.3, 0.6)).x(), 5);
  EXPECT_LT(default_start(both, disc(0.49, 0.98)).x(), 5);  // the corridor's part is a thin line
  const Map closet = square(1.2);
  EXPECT_GT(distance_to_walls(closet.free, default_start(closet, disc(0.5, 1))), 0.55);
  for (const auto seed : seeds(12))
    for (const std::string name : {"maze", "cave", "clutter", "rooms", "speckle"}) {
      const Map map = oxturn::generate(name, {{"width", 12.0}, {"height", 12.0}}, seed);
      for (const double radius : {0.05, 0.2, 0.35}) {
        SCOPED_TRACE(map.source + " " + std::to_string(radius));
        try {
          const Problem p(map, disc(radius, 2 * radius));
          EXPECT_TRUE(p.walls().contains(p.start()));
          EXPECT_GE(distance_to_walls(map.free, p.start()), radius);
        } catch (const std::invalid_argument& fits_nowhere) {
          EXPECT_THAT(fits_nowhere.what(), HasSubstr("fits nowhere"));
        }
      }
    }
}

TEST(Problem, FarFromTheOriginNothingIsLost) {
  const Problem near(square(10), disc(0.5, 1), Point(5, 5));
  const Point far(5e5, 4e6);
  const Problem p(square(10, far), disc(0.5, 1), Point(far + Point(5, 5)));
  EXPECT_NEAR(area(p.configuration_space()), area(near.configuration_space()), 1e-4);
  EXPECT_NEAR(area(p.target()), area(near.target()), 1e-3);
}

TEST(Problem, RestrictedHasLessRoomAndTheSameTarget) {
  const Problem p(square(10), disc(0.5, 1), Point(5, 5));
  const Problem small = p.restricted(box_region({4, 4}, {6, 6}));
  EXPECT_DOUBLE_EQ(area(small.configuration_space()), 4);
  EXPECT_EQ(&small.target(), &p.target());
  EXPECT_FALSE(small.walls().contains(Point(2, 2)));
  EXPECT_FALSE(small.transit().path({5, 5}, {2, 2}).has_value());
  EXPECT_THAT(complaint([&] {
                p.restricted(box_region({1, 1}, {2, 2}));
              }),
              HasSubstr("does not hold the start (5, 5)"));
}

TEST(Problem, RestrictedMayShareShortestPaths) {
  const Problem p(square(10), disc(0.5, 1), Point(5, 5));
  const Problem small = p.restricted(box_region({4, 4}, {6, 6}), Problem::Transit::shared);
  EXPECT_FALSE(small.walls().contains(Point(2, 2)));
  EXPECT_TRUE(small.transit().path({5, 5}, {2, 2}).has_value());
  EXPECT_EQ(&small.transit(), &p.transit());
  const Problem smaller = small.restricted(box_region({4.5, 4.5}, {5.5, 5.5}), Problem::Transit::shared);
  EXPECT_EQ(&smaller.transit(), &p.transit());
  EXPECT_NE(&small.restricted(small.configuration_space()).transit(), &p.transit());
  EXPECT_EQ(&small.turning_on_the_spot().transit(), &p.transit());
}

TEST(Problem, HashDependsOnWhatDeterminesThePlan) {
  const auto hash = [](Map map, Robot robot, Point start) {
    return Problem(std::move(map), robot, start).content_hash();
  };
  const std::string base = hash(square(10), disc(0.5, 1), {5, 5});
  Map turned = square(10);
  std::rotate(turned.free.polygons[0].outer.begin(), turned.free.polygons[0].outer.begin() + 1,
              turned.free.polygons[0].outer.end());
  turned.name = "other";
  EXPECT_EQ(hash(turned, disc(0.5, 1), {5, 5}), base);
  EXPECT_NE(hash(square(11), disc(0.5, 1), {5, 5}), base);
  EXPECT_NE(hash(square(10), disc(0.5, 1.1), {5, 5}), base);
  EXPECT_NE(hash(square(10), disc(0.5, 1), {5, 5.1}), base);
  Robot leashed = disc(0.5, 1);
  leashed.tether = Tether{20};
  EXPECT_NE(hash(square(10), leashed, {5, 5}), base);
}

TEST(Problem, LazyPartsAreMadeOnceForAllThreads) {
  const Problem p = drawn(random_rows(5, 12));
  std::vector<const void*> seen(8);
  std::vector<std::thread> threads;
  for (std::size_t k = 0; k < 4; ++k)
    threads.emplace_back([&, k] {
      seen[2 * k] = &p.walls();
      seen[2 * k + 1] = &p.transit();
      (void)p.target_excess();
    });
  for (std::thread& t : threads) t.join();
  for (std::size_t k = 1; k < 4; ++k) {
    EXPECT_EQ(seen[2 * k], seen[0]);
    EXPECT_EQ(seen[2 * k + 1], seen[1]);
  }
}

}  // namespace
}  // namespace oxturn
