#include "geometry/predicates.hpp"

#include <gtest/gtest.h>

#include "base/random.hpp"

namespace oxturn {
namespace {

__extension__ typedef __int128 Wide;

int sign(Wide v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

// Points on a fine lattice nearly or exactly in line; the truth is in integers.
TEST(Orientation, IsExactNextToALine) {
  Rng rng(1);
  for (int round = 0; round < 200000; ++round) {
    const auto big = [&] { return static_cast<std::int64_t>(rng.below(1u << 26)) - (1 << 25); };
    const std::int64_t ax = big(), ay = big(), dx = big(), dy = big(), k = rng.between(-40, 40);
    const std::int64_t bx = ax + dx, by = ay + dy;
    const std::int64_t cx = ax + k * dx + rng.between(-1, 1), cy = ay + k * dy + rng.between(-1, 1);
    const Wide det = Wide{bx - ax} * (cy - ay) - Wide{by - ay} * (cx - ax);
    const double unit = std::ldexp(1.0, rng.between(-60, 60));
    const auto at = [&](std::int64_t x, std::int64_t y) {
      return Point(static_cast<double>(x) * unit, static_cast<double>(y) * unit);
    };
    ASSERT_EQ(orientation(at(ax, ay), at(bx, by), at(cx, cy)), sign(det));
  }
}

// The classic: a 256 x 256 neighbourhood of one ulp steps, where rounded products give noise.
TEST(Orientation, IsExactInStepsOfOneUlp) {
  const double step = 0x1p-53;
  for (int i = 0; i < 256; ++i)
    for (int j = 0; j < 256; ++j) {
      const Point p(0.5 + i * step, 0.5 + j * step);
      ASSERT_EQ(orientation(p, {12, 12}, {24, 24}), i == j ? 0 : i < j ? 1 : -1) << i << ' ' << j;
    }
}

TEST(Orientation, ChangesSignWithTheOrder) {
  Rng rng(2);
  for (int k = 0; k < 1000; ++k) {
    const Point a(rng.normal(), rng.normal()), b(rng.normal(), 1e-12 * rng.normal()), c = lerp(a, b, rng.unit());
    EXPECT_EQ(orientation(a, b, c), orientation(b, c, a));
    EXPECT_EQ(orientation(a, b, c), -orientation(b, a, c));
  }
  EXPECT_EQ(orientation({1e100, 1}, {1e100, 1}, {3, 4}), 0);
  EXPECT_EQ(orientation({0, 0}, {1e-120, 0}, {0, 1e-120}), 1);
}

// All pairs of segments on a 4 x 4 lattice, against the solution of the two linear equations.
TEST(Crossing, AgreesWithIntegersOnAllSmallSegments) {
  const auto truth = [](int ax, int ay, int bx, int by, int cx, int cy, int dx, int dy) {
    const int ux = bx - ax, uy = by - ay, vx = dx - cx, vy = dy - cy, wx = cx - ax, wy = cy - ay;
    int det = ux * vy - uy * vx;
    if (det != 0) {
      int t = wx * vy - wy * vx, s = wx * uy - wy * ux;
      if (det < 0) t = -t, s = -s, det = -det;
      if (t < 0 || t > det || s < 0 || s > det) return Crossing::none;
      return t > 0 && t < det && s > 0 && s < det ? Crossing::proper : Crossing::touch;
    }
    // Parallel or a point: compare along the longer direction, in line or apart.
    const bool first = ux != 0 || uy != 0;
    const int gx = first ? ux : vx, gy = first ? uy : vy;
    if (gx == 0 && gy == 0) return wx == 0 && wy == 0 ? Crossing::touch : Crossing::none;
    if (gx * wy - gy * wx != 0) return Crossing::none;
    const auto along = [&](int x, int y) { return gx * x + gy * y; };
    const int low = std::max(std::min(along(ax, ay), along(bx, by)), std::min(along(cx, cy), along(dx, dy)));
    const int high = std::min(std::max(along(ax, ay), along(bx, by)), std::max(along(cx, cy), along(dx, dy)));
    return low > high ? Crossing::none : low == high ? Crossing::touch : Crossing::overlap;
  };
  for (int n = 0; n < 65536; ++n) {
    const int ax = n & 3, ay = n >> 2 & 3, bx = n >> 4 & 3, by = n >> 6 & 3, cx = n >> 8 & 3, cy = n >> 10 & 3,
              dx = n >> 12 & 3, dy = n >> 14 & 3;
    ASSERT_EQ(crossing(Point(ax, ay), Point(bx, by), Point(cx, cy), Point(dx, dy)),
              truth(ax, ay, bx, by, cx, cy, dx, dy))
        << n;
  }
}

TEST(OnSegment, MeansExactly) {
  EXPECT_TRUE(on_segment({1, 1}, {0, 0}, {3, 3}));
  EXPECT_TRUE(on_segment({3, 3}, {0, 0}, {3, 3}));
  EXPECT_FALSE(on_segment({std::nextafter(1.0, 2), 1}, {0, 0}, {3, 3}));
  EXPECT_FALSE(on_segment({4, 4}, {0, 0}, {3, 3}));
  EXPECT_FALSE(on_segment({0.1, 0.3}, {0, 0}, {0.2, 0.6000000000000001}));
}

}  // namespace
}  // namespace oxturn
