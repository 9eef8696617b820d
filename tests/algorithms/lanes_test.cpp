#include "algorithms/lanes/lanes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "algorithms/lanes/lane_direction.hpp"
#include "maps/generators.hpp"
#include "tests/support/drawn.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

TEST(LaneFrame, MakesLanesVerticalAndBack) {
  Rng rng(1);
  for (const double degrees : {0.0, 90.0, 180.0, 270.0, -90.0, 12.5, 133.0}) {
    const LaneFrame frame(degrees);
    const double a = degrees * kPi / 180;
    const Point along = frame.to_frame({std::cos(a), std::sin(a)});
    EXPECT_NEAR(along.x(), 0, 1e-12);
    EXPECT_NEAR(along.y(), 1, 1e-12);
    const Point p(rng.between(-9.0, 9.0), rng.between(-9.0, 9.0));
    EXPECT_LT(distance(frame.to_world(frame.to_frame(p)), p), 1e-14);
    if (std::fmod(degrees, 90) == 0) { EXPECT_EQ(frame.to_world(frame.to_frame(p)), p); }
  }
}

// The tool is much wider than the robot, so the cave has many vertices per tool width: the region is found from fewer
// of them, which may make it larger, but by less than the chord error.
TEST(LaneRegion, OfACaveWithManyVerticesPerToolErrsOutsideByTheChordErrorAtMost) {
  for (const auto seed : seeds(2)) {
    Robot robot;
    robot.radius = 0.05;
    robot.tool_width = 3;
    const Map map = generate("cave", {{"width", 12.0}, {"height", 8.0}, {"robot", 0.05}}, seed);
    const Problem whole(map, robot);
    const Problem problem = whole.restricted(whole.configuration_space());
    const Region& space = problem.configuration_space();
    ASSERT_GT(static_cast<double>(vertex_count(space)) * robot.tool_width, 20 * perimeter(space));
    const double inset = 0.2, chord = 0.028;
    const EdgeIndex lanes(lane_region(problem, inset, chord));
    ASSERT_FALSE(lanes.edges().empty());
    Rng rng(seed);
    const Box box = bounding_box(space);
    for (int k = 0; k < 2000; ++k) {
      const Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
      if (!problem.walls().contains(p)) continue;
      const double away = problem.walls().nearest(p)->distance;
      if (away >= inset) { EXPECT_TRUE(lanes.contains(p)) << away; }
      if (away < inset - chord) { EXPECT_FALSE(lanes.contains(p)) << away; }
    }
  }
}

TEST(Slabs, AreTheFewestThatFit) {
  EXPECT_EQ(slabs_over(0, 4, 0.4).count, 10u);
  EXPECT_EQ(slabs_over(1e6, 1e6 + 3 * 0.1, 0.1).count, 3u);
  EXPECT_EQ(slabs_over(0, 4.01, 0.4).count, 11u);
  EXPECT_EQ(slabs_over(2, 2, 0.4).count, 1u);
  const Slabs s = slabs_over(1, 8, 0.3);
  EXPECT_NEAR(s.line(0), 1, 1e-12);
  EXPECT_NEAR(s.line(s.count), 8, 1e-12);
}

// Every point of the region is in an interval of its slab; every height of an interval is that of a point (sampled).
TEST(Project, IsTheProjectionOfEachSlab) {
  for (const auto seed : seeds(6))
    for (const char* name : {"cave", "field", "polygon"}) {
      SCOPED_TRACE(std::string(name) + " " + std::to_string(seed));
      const Region region = generate(name, {{"width", 10.0}, {"height", 10.0}}, seed).free;
      const Box box = bounding_box(region);
      const Slabs slabs = slabs_over(box.low.x(), box.high.x(), 0.7);
      const Projection all = project(edges_of(region), slabs);
      Rng rng(seed);
      for (int i = 0; i < 2000; ++i) {
        const Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
        if (!contains(region, p)) continue;
        const auto k = static_cast<std::size_t>((p.x() - slabs.first) / slabs.width);
        EXPECT_TRUE(std::any_of(all.intervals.begin(), all.intervals.end(), [&](const LaneInterval& s) {
          return s.slab == k && s.low <= p.y() && p.y() <= s.high;
        }));
      }
      for (const LaneInterval& s : all.intervals) {
        const double y = rng.between(s.low, s.high);
        bool found = s.high - s.low < 1e-3;  // too short for samples
        for (int i = 0; i <= 4000 && !found; ++i)
          found = contains(region, {slabs.line(s.slab) + slabs.width * i / 4000, y});
        EXPECT_TRUE(found) << s.slab << " " << y;
      }
      for (std::size_t i = 1; i < all.intervals.size(); ++i) {
        const LaneInterval &a = all.intervals[i - 1], &b = all.intervals[i];
        EXPECT_TRUE(a.slab < b.slab || (a.slab == b.slab && a.high < b.low));
      }
      for (const auto& [a, b] : all.links) EXPECT_EQ(all.intervals[a].slab + 1, all.intervals[b].slab);
    }
}

TEST(Project, LinksFollowTheRegionNotTheHeights) {
  // A wall from slab line 2 to 3 with a gap at the bottom: its two sides are connected only through the gap.
  const Region region = drawn_region({"..#..", "..#..", "....."});
  const Projection all = project(edges_of(region), {0, 1, 5});
  ASSERT_EQ(all.intervals.size(), 5u);  // the wall's slab has the gap alone
  EXPECT_NEAR(all.intervals[2].high, 1, 1e-12);
  EXPECT_EQ(all.links.size(), 4u);
}

TEST(ClipVertical, AgreesWithSampling) {
  for (const auto seed : seeds(10)) {
    const Region region = generate("cave", {{"width", 10.0}, {"height", 10.0}}, seed).free;
    const EdgeIndex space(region);
    Rng rng(seed);
    for (int i = 0; i < 50; ++i) {
      const double x = rng.between(-0.5, 10.5), low = rng.between(-1.0, 6.0), high = low + rng.between(0.0, 6.0);
      const auto pieces = clip_vertical(space, x, low, high, 1e-9);
      for (int k = 0; k < 40; ++k) {
        const double y = rng.between(low, high);
        const bool in =
            std::any_of(pieces.begin(), pieces.end(), [&](const auto& s) { return s.first <= y && y <= s.second; });
        EXPECT_EQ(in, contains(region, {x, y})) << x << " " << y;
      }
      for (const auto& [a, b] : pieces) EXPECT_TRUE(space.contains({x, a}, {x, b}));
    }
  }
}

TEST(LaneDirection, FollowsALongHall) {
  for (const double degrees : {0.0, 17.0, 90.0, 141.5}) {
    const Region hall = transformed(box_region({0, 0}, {20, 3}), degrees * kPi / 180, {3, 4});
    EXPECT_NEAR(std::remainder(best_lane_direction(hall, 0.4) - degrees, 180), 0, 0.2) << degrees;
  }
}

}  // namespace
}  // namespace oxturn
