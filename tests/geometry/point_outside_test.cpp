#include "geometry/point_outside.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.hpp"
#include "random_region.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

constexpr double kTolerance = 1e-6;

/// Two rooms side by side along the line x = 0.2, with a wall from y = 3 to y = 4 between them, and a door far away.
Region two_rooms() { return {{{{{0.2, 0}, {9, 0}, {9, 8}, {0.2, 8}, {0.2, 4}, {7, 4}, {7, 3}, {0.2, 3}}, {}}}}; }

// Along a wall that both rooms share, beside it by less than the tolerance: edges that only end there must be seen.
TEST(PointOutside, SeesAWallBetweenEdgesThatLieBesideTheSegment) {
  const EdgeIndex walls(two_rooms());
  const double beside = std::nextafter(0.2, 0);
  for (const double x : {0.2, beside, 0.2 - kTolerance / 2, 0.2 + kTolerance / 2})
    for (const double below : {0.5, 2.5, 2.999})
      for (const double above : {4.001, 4.5, 4.7, 7.5}) {
        const auto found = point_outside(walls, {x, below}, {x, above}, kTolerance);
        ASSERT_TRUE(found) << x << " from " << below << " to " << above;
        EXPECT_GT(found->y(), 3);
        EXPECT_LT(found->y(), 4);
        EXPECT_TRUE(point_outside(walls, {x, above}, {x, below}, kTolerance));
      }
}

// What is beside a wall by less than the tolerance is not outside.
TEST(PointOutside, AllowsTheTolerance) {
  const EdgeIndex walls(two_rooms());
  for (const double off : {0.0, 0.5, 0.99, 1.01, 2.0}) {
    const double x = 0.2 - off * kTolerance;
    EXPECT_EQ(point_outside(walls, {x, 0.5}, {x, 2.5}, kTolerance).has_value(), off > 1) << off;
  }
}

// Against points every thousandth of the segment.
TEST(PointOutside, AgreesWithADenseSample) {
  const EdgeIndex walls(two_rooms());
  for (const auto seed : seeds(2000)) {
    Rng rng(seed);
    const auto near = [&](double v) { return v + kTolerance * rng.between(-0.5, 0.5); };
    const auto point = [&]() -> Point {
      const double xs[] = {0.2, 7, 9, rng.between(0.0, 10.0)}, ys[] = {0, 3, 4, 8, rng.between(0.0, 8.0)};
      return {near(xs[rng.between(0, 3)]), near(ys[rng.between(0, 4)])};
    };
    const Point a = point(), b = point();
    bool all_inside = true;
    for (int k = 0; k <= 1000; ++k) all_inside &= nearly_contains(walls, lerp(a, b, k / 1000.0), kTolerance);
    const auto found = point_outside(walls, a, b, kTolerance);
    EXPECT_TRUE(found || all_inside) << seed;
    EXPECT_FALSE(found && nearly_contains(walls, *found, kTolerance)) << seed;
  }
}

// With and without an index, on walls and at corners too.
TEST(NearlyContains, APolygonSaysWhatItsIndexSays) {
  std::size_t inside = 0, outside = 0;
  for (const auto seed : seeds(100)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Region region = clutter_box(rng, 4, 3, seed % 2 == 0);
    const Polygon& polygon = region.polygons.front();
    const EdgeIndex walls(region);
    std::vector<Point> points;
    for_each_edge(region, [&](const Point& a, const Point& b) {
      const Point beside = perpendicular(b - a).normalized() * kTolerance;
      for (const Point& p : {a, lerp(a, b, 0.5), lerp(a, b, rng.unit())})
        for (const double off : {0.0, 0.5, -0.5, 2.0, -2.0}) points.push_back(p + off * beside);
    });
    for (int k = 0; k < 100; ++k) points.push_back({rng.between(-0.5, 4.5), rng.between(-0.5, 3.5)});
    for (const Point& p : points)
      for (const double tolerance : {0.0, kTolerance}) {
        const bool holds = nearly_contains(walls, p, tolerance);
        EXPECT_EQ(nearly_contains(polygon, p, tolerance), holds) << p.transpose() << " within " << tolerance;
        ++(holds ? inside : outside);
      }
  }
  EXPECT_GT(inside, 10'000u);
  EXPECT_GT(outside, 10'000u);
}

}  // namespace
}  // namespace oxturn
