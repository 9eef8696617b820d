// Lower bounds of length: never above the truth, and as strong as they should be where the truth is known.
#include "metrics/spill.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/swath.hpp"
#include "metrics/disc_area.hpp"
#include "metrics/length_bound.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

constexpr double kRadius = 0.5;

Path driven(Polyline line) {
  Path path;
  path.legs.push_back({true, std::move(line)});
  return path;
}

/// A target in a wide free space, for a tool of width 1.
Problem lawn(Region target, const Point& start) {
  Box box = bounding_box(target);
  box.grow(4);
  Robot robot;
  robot.radius = 0.5;
  robot.tool_width = 1;
  Map map{"lawn", box_region(box.low, box.high), "test", ""};
  map.target_area = std::move(target);
  return Problem(std::move(map), robot, start);
}

std::optional<LengthBound> bound_of(const Problem& problem, const Path& path) {
  return length_bound(problem, path, swept_area(problem.target(), problem.target_excess(), 1, path), true);
}

double disc_in(const Region& region, const Point& centre, double radius) {
  DiscArea common(centre, radius);
  for_each_edge(region, [&](const Point& a, const Point& b) { common.add(a, b); });
  return common.area();
}

TEST(DiscArea, AgreesWithTheOverlay) {
  Rng rng(5);
  for (int k = 0; k < 200; ++k) {
    Ring ring;
    for (int i = 0; i < 5; ++i) ring.emplace_back(rng.between(-2.0, 2.0), rng.between(-2.0, 2.0));
    const Point centre(rng.between(-2.0, 2.0), rng.between(-2.0, 2.0));
    const double radius = rng.between(0.2, 2.0);
    double sum = 0;  // the boundary winds, so the oracle is a sum over the triangles of a fan
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      Ring triangle{ring[0], ring[i], ring[i + 1]};
      const double sign = signed_area(triangle) > 0 ? 1 : -1;
      if (sign < 0) std::reverse(triangle.begin(), triangle.end());
      const Region disc = swath({{centre}}, radius, 1e-5, Bound::inside);
      sum += sign * area(intersect(disc, Region{{{triangle, {}}}}));
    }
    DiscArea exact(centre, radius);
    for_each_edge(ring, [&](const Point& a, const Point& b) { exact.add(a, b); });
    EXPECT_NEAR(exact.area(), sum, 2e-3);
  }
}

// Vertices and centres on a coarse grid, so that centres lie on vertices and edges; many turns, left and right; from a
// millionth to a million. The oracle adds the angles one by one.
TEST(DiscArea, CountsWholeTurns) {
  Rng rng(6);
  for (int k = 0; k < 50'000; ++k) {
    const double scale = std::ldexp(1.0, k % 41 - 20);  // exact
    const auto coordinate = [&] { return scale * std::round(rng.between(-3.0, 3.0)); };
    const auto on_grid = [&] { return Point(coordinate(), coordinate()); };
    Ring ring;
    for (int i = 0; i < 3 + k % 40; ++i) ring.push_back(on_grid());
    const Point centre = on_grid();
    // No edge but those through the centre is so near.
    const double radius = 0.1 * scale;
    DiscArea common(centre, radius);
    double angle = 0;
    for_each_edge(ring, [&](const Point& p, const Point& q) {
      const Point a = p - centre, b = q - centre;
      common.add(p, q);
      const bool through = cross(a, b) == 0 && a.dot(b) <= 0;  // its triangle has no area
      if (!through) angle += std::atan2(cross(a, b), a.dot(b));
    });
    EXPECT_NEAR(common.area(), radius * radius / 2 * angle, 1e-9 * radius * radius) << k;
  }
}

// The least that any disc about a point within reach of a square's corner has outside, by a fine grid of centres.
TEST(Spill, FourCornersOfASquare) {
  const Region square = box_region({0, 0}, {10, 10});
  double least = 1;
  for (double x = -0.5; x <= 0.5; x += 0.005)
    for (double y = -0.5; y <= 0.5; y += 0.005)
      if (x * x + y * y <= kRadius * kRadius)
        least = std::min(least, kPi * kRadius * kRadius - disc_in(square, {x, y}, kRadius));
  EXPECT_LE(least_spill(square, 1, 0, {}), 4 * least);
  EXPECT_GE(least_spill(square, 1, 0, {}), 0.93 * 4 * least);
  const Region scaled = box_region({0, 0}, {25, 25});
  EXPECT_NEAR(least_spill(scaled, 2.5, 0, {}), 6.25 * least_spill(square, 1, 0, {}), 1e-9);
}

TEST(Spill, UncoveredAreaSavesIt) {
  const Region square = box_region({0, 0}, {10, 10});
  double last = least_spill(square, 1, 0, {});
  EXPECT_LT(least_spill(square, 1, 1e-3, {}), 0.99 * last);
  for (const double uncovered : {1e-4, 1e-3, 1e-2, 0.1, 0.3}) {
    const double spill = least_spill(square, 1, uncovered, {});
    EXPECT_LE(spill, last);
    last = spill;
  }
  EXPECT_NEAR(last, 0, 1e-12);
}

// What a straight path sweeps, and bites out of it: the path spills exactly the bites, and is the shortest.
TEST(LengthBound, IsNeverAboveAStraightPath) {
  for (const auto seed : seeds(4)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Point a(0, 0), b = rotated({rng.between(2.0, 9.0), 0}, rng.between(0.0, 6.0));
    Region target = swath({{a, b}}, kRadius, 2e-3, Bound::inside);
    for (int k = 0; k < 3; ++k) {
      const Point at = lerp(a, b, rng.unit()) + Point(rng.between(-0.6, 0.6), rng.between(-0.6, 0.6));
      const double side = rng.between(0.1, 0.5);
      target = subtract(target, box_region(at - Point(side, side) / 2, at + Point(side, side) / 2));
    }
    const Problem problem = lawn(target, a);
    const auto bound = bound_of(problem, driven({a, b}));
    ASSERT_TRUE(bound);
    EXPECT_LE(bound->metres, distance(a, b));
    EXPECT_GE(bound->metres, 0.75 * distance(a, b));
  }
}

// The path to the target, and what the first disc covers and spills.
TEST(LengthBound, CountsThePathToTheTarget) {
  for (const double before : {0.0, 0.3, 0.5, 0.8, 1.3, 2.0, 3.5}) {
    SCOPED_TRACE(before);
    const Point a(0, 0), b(8, 0), start(-before, 0);
    const Problem problem = lawn(swath({{a, b}}, kRadius, 2e-3, Bound::inside), start);
    const auto bound = bound_of(problem, driven({start, b}));
    ASSERT_TRUE(bound);
    EXPECT_LE(bound->metres, 8 + before);
    EXPECT_GE(bound->metres, 7.9 + std::min(0.7 * before, 0.5 * kPi * kRadius * kRadius) + std::max(0.0, before - 1.3));
  }
}

// Around a wall between the start and the target: the shortest path there is known.
TEST(LengthBound, CountsThePathAroundAWall) {
  Robot robot;
  robot.radius = 0.5;
  robot.tool_width = 1;
  Map map{"wall", subtract(box_region({0, 0}, {20, 10}), box_region({9.5, 0}, {10.5, 8})), "test", ""};
  map.target_area = box_region({12, 1}, {19, 2});
  const Point start(8, 1.5), before(9.5, 8.5), behind(10.5, 8.5);
  const Problem problem(std::move(map), robot, start);
  const Point over_left = before + Point(-0.5, 0), over_right = behind + Point(0.5, 0);  // where the arcs are cut short
  const Polyline line{start, over_left, over_right, {12, 1.5}, {18.6, 1.5}};
  const Path path = driven(line);
  const auto bound = bound_of(problem, path);
  ASSERT_TRUE(bound);
  EXPECT_LE(bound->metres, length(line));
  EXPECT_GE(bound->metres, 0.93 * length(line));
  // Of a path through the wall nothing is known but the area that it covers.
  const auto of_any =
      length_bound(problem, path, swept_area(problem.target(), problem.target_excess(), 1, path), false);
  ASSERT_TRUE(of_any);
  EXPECT_LT(of_any->metres, 8);
}

// Strips narrower than the tool: from where the disc holds two corners to where it holds the other two.
TEST(LengthBound, IsNeverAboveTheOptimumOfAStrip) {
  for (const double wide : {0.1, 0.3, 0.6, 0.9, 0.99})
    for (const double along : {1.0, 2.5, 7.0}) {
      SCOPED_TRACE(testing::Message() << wide << " x " << along);
      const double end = std::sqrt(kRadius * kRadius - wide * wide / 4);
      if (along <= 2 * end) continue;
      const Point from(end, wide / 2), to(along - end, wide / 2);
      const Problem problem = lawn(box_region({0, 0}, {along, wide}), from);
      const Path path = driven({from, to});
      EXPECT_GT(swept_area(problem.target(), 0, 1, path).coverage.upper, 0.9999);
      const auto bound = bound_of(problem, path);
      if (bound) { EXPECT_LE(bound->metres, distance(from, to)); }
      if (bound && along > 5 && wide > 0.5) { EXPECT_NE(bound->kind, LengthBound::Kind::area); }
    }
}

// One position covers it: there is no bound.
TEST(LengthBound, OfASmallSquareIsNothing) {
  for (const double side : {0.1, 0.4, 0.7}) {
    const Point middle(side / 2, side / 2);
    const Problem problem = lawn(box_region({0, 0}, {side, side}), middle);
    EXPECT_FALSE(bound_of(problem, driven({middle, middle + Point(1e-6, 0)})));
  }
}

// Random paths that cover anything from little to nearly all of random targets.
TEST(LengthBound, IsNeverAboveRandomPaths) {
  for (const auto seed : seeds(30)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    std::vector<Region> boxes;
    for (int k = 0; k < 4; ++k) {
      const Point low(rng.between(0.0, 2.0), rng.between(0.0, 2.0));
      boxes.push_back(box_region(low, low + Point(rng.between(0.2, 2.0), rng.between(0.2, 2.0))));
    }
    Polyline line{{0, 0}};
    const int vertices = rng.between(2, 14);
    for (int k = 0; k < vertices; ++k) line.emplace_back(rng.between(-0.2, 3.5), rng.between(-0.2, 3.5));
    const Problem problem = lawn(unite(boxes), line.front());
    if (const auto bound = bound_of(problem, driven(line))) { EXPECT_LE(bound->metres, length(line)); }
  }
}

}  // namespace
}  // namespace oxturn
