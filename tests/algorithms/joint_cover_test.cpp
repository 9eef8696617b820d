#include "algorithms/lanes/joint_cover.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/math.hpp"
#include "base/random.hpp"
#include "geometry/edge_index.hpp"

namespace oxturn {
namespace {

using Segments = std::vector<Segment>;

Point polar(double radius, double angle) { return {radius * math::cos(angle), radius * math::sin(angle)}; }

/// The arc about the origin as a line of so many segments.
Segments arc(double radius, double from, double to, int n) {
  Segments all;
  for (int k = 0; k < n; ++k)
    all.push_back({polar(radius, from + (to - from) * k / n), polar(radius, from + (to - from) * (k + 1) / n)});
  return all;
}
/// What lies between two radii and two angles.
Ring band(double inner, double outer, double from, double to, int n) {
  Ring ring;
  for (int k = 0; k <= n; ++k) ring.push_back(polar(outer, from + (to - from) * k / n));
  for (int k = n; k >= 0; --k) ring.push_back(polar(inner, from + (to - from) * k / n));
  return ring;
}
double clearance(const Point& p, const Segments& segments) {
  double least = std::numeric_limits<double>::infinity();
  for (const Segment& s : segments) least = std::min(least, distance_to_segment(p, s.a, s.b));
  return least;
}

/// Oracle: the points of a fine grid inside the ring.
bool covers_samples(const Segments& segments, double radius, const Ring& ring, int n) {
  const EdgeIndex inside(Region{{{ring, {}}}});
  const Box box = bounding_box(ring);
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const Point p = box.low + Point(box.size().x() * i / n, box.size().y() * j / n);
      if (inside.contains(p) && clearance(p, segments) > radius + 1e-9) return false;
    }
  return true;
}

// Segments in a ring about an uncovered hole, in rows, or anywhere; rings star-shaped, and as wavy as that allows.
Segments some_segments(Rng& random, double radius) {
  const int n = 1 + static_cast<int>(random.below(14));
  const double turn = random.between(0.0, 2 * kPi);
  switch (random.below(3)) {
    case 0:
      return arc(radius * random.between(0.9, 1.6), turn, turn + random.between(1.0, 2 * kPi), n + 3);
    case 1: {
      Segments rows;
      const double step = radius * random.between(1.0, 2.2);
      for (int k = -2; k <= 2; ++k) rows.push_back({{-3, k * step}, {3, k * step}});
      return rows;
    }
    default: {
      Segments all;
      for (int k = 0; k < n; ++k) {
        const double x = random.between(-1.0, 1.0), y = random.between(-1.0, 1.0), size = random.between(0.0, 2.0);
        all.push_back({{x, y}, Point(x, y) + polar(size, random.between(0.0, 2 * kPi))});
      }
      return all;
    }
  }
}

TEST(JointCover, NeverClaimsWhatIsNotCovered) {
  Rng random(1);
  int claimed = 0, covered = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    const double radius = 0.5;
    const Segments segments = some_segments(random, radius);
    const int n = 3 + static_cast<int>(random.below(20));
    const double size = random.between(0.1, 1.2);
    const double x = random.between(-0.5, 0.5), y = random.between(-0.5, 0.5);
    Ring ring;
    for (int k = 0; k < n; ++k) ring.push_back(Point(x, y) + polar(size * random.between(0.4, 1.0), 2 * kPi * k / n));
    const bool all = covers_samples(segments, radius, ring, 40);
    covered += all;
    if (!cover_inside(segments, radius, ring)) continue;
    ++claimed;
    ASSERT_TRUE(all) << trial;
  }
  EXPECT_GE(claimed, 2000);
  EXPECT_GE(claimed, 0.75 * covered);
}

TEST(JointCover, SeesTheHoleThatSegmentsGoRound) {
  const Segments round = arc(0.6, 0, 2 * kPi, 12);
  Ring ring;
  for (int k = 0; k < 40; ++k) ring.push_back(polar(0.6, 2 * kPi * k / 40));
  EXPECT_FALSE(cover_inside(round, 0.5, ring));
  EXPECT_TRUE(cover_inside(round, 0.62, ring));
}

// As repair meets them: what lies between a wall and the boundary of configuration space round a corner.
TEST(JointCover, FindsBandsBesideArcs) {
  Rng random(2);
  int found = 0;
  const int all = 1000;
  for (int trial = 0; trial < all; ++trial) {
    const double radius = 0.5, from = random.between(0.0, 2 * kPi), turn = random.between(0.2, 3.1),
                 turning = random.between(0.5, 2.0);
    const Segments beside = arc(turning, from, from + turn, 12);
    const double inner = turning - random.between(0.2, 0.98) * std::min(radius, turning);
    found += cover_inside(beside, radius, band(inner, turning, from, from + turn, 8));
  }
  EXPECT_GE(found, 0.95 * all);
}

TEST(JointCover, TakesRingsOfAnyShape) {
  const Segments one = {{{0, 0}, {1, 0}}};
  EXPECT_TRUE(cover_inside(one, 0.5, {{0, 0}, {1, 0}, {0, 0}}));
  EXPECT_TRUE(cover_inside(one, 0.5, {{0.5, 0}, {0.5, 0}, {0.5, 0}}));
  EXPECT_FALSE(cover_inside({}, 0.5, {{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_FALSE(cover_inside(one, 1e-9, {{0, 0}, {1, 0}, {0.5, 1e-10}}));  // billions of parts
  EXPECT_FALSE(cover_inside(Segments(65, one[0]), 0.5, {{0, 0}, {0.1, 0}, {0, 0.1}}));
}

}  // namespace
}  // namespace oxturn
