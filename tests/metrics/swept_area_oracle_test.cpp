// Areas and visits by brute force: a grid of points, and a walk along the path for each of them.
#include <gtest/gtest.h>

#include "metrics/swept_area.hpp"
#include "shapes.hpp"
#include "tests/support/seeds.hpp"
#include "tethered.hpp"

namespace oxturn {
namespace {

struct Counts {
  double target = 0, covered = 0, visits = 0, swept = 0;
};  // m^2

/// Visits of one point: follows the path in time, segment by segment, by the roots of |p(t) - x| = r.
int visits_of(const Path& path, const Point& x, double r) {
  int visits = 0;
  bool on = false, under = false;
  Point last(0, 0);
  for (const Leg& leg : path.legs) {
    if (!leg.tool) {
      on = under = false;
      continue;
    }
    if (!on || last != leg.points.front()) under = distance(x, leg.points.front()) <= r, visits += under;
    on = true;
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      const bool touches = distance_to_segment(x, leg.points[i - 1], leg.points[i]) <= r;
      if (touches && !under) ++visits;
      under = distance(x, leg.points[i]) <= r;
    }
    last = leg.points.back();
  }
  return visits;
}

Counts count(const Region& target, const Path& path, double width, double pitch) {
  Counts c;
  Box box = bounding_box(target);
  box.grow(width);
  Rng rng(99);  // one random point a cell: a plain grid errs by a whole row along a straight wall
  for (double y = box.low.y(); y < box.high.y(); y += pitch) {
    for (double x = box.low.x(); x < box.high.x(); x += pitch) {
      const double dx = rng.unit(), dy = rng.unit();
      const Point p = Point(x, y) + pitch * Point(dx, dy);
      const bool wanted = contains(target, p);
      int legs = 0;
      for (const Leg& leg : path.legs) {
        bool hit = false;
        for (std::size_t i = 1; leg.tool && !hit && i < leg.points.size(); ++i)
          hit = distance_to_segment(p, leg.points[i - 1], leg.points[i]) <= width / 2;
        legs += hit;
      }
      c.swept += legs > 0;
      if (!wanted) continue;
      c.target += 1;
      c.covered += legs > 0;
      c.visits += visits_of(path, p, width / 2);
    }
  }
  for (double* v : {&c.target, &c.covered, &c.visits, &c.swept}) *v *= pitch * pitch;
  return c;
}

void compare(const Region& target, const Path& path, double width) {
  const double pitch = width / 12;
  const Counts truth = count(target, path, width, pitch);
  const SweptArea s = swept_area(target, 0, width, path);
  // The grid errs by pitch^2 times half the root of the cells on the boundary; this is some four times that.
  const double slack = 0.004 * (truth.swept + width * width) + 0.002 * truth.target;
  EXPECT_NEAR(s.covered_m2, truth.covered, slack);
  EXPECT_NEAR(s.covered_estimate_m2, truth.covered, slack);
  EXPECT_NEAR(s.coverage.middle() * area(target), truth.covered, slack);
  EXPECT_NEAR(s.union_m2, truth.swept, slack);
  EXPECT_NEAR(s.visits_m2, truth.visits, 0.006 * truth.visits + slack);
  EXPECT_LE(s.coverage.upper - s.coverage.lower, 0.001);
  EXPECT_LE(s.coverage.lower, s.coverage.upper);
}

TEST(SweptOracle, RandomWalks) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const double angle = seed % 3 ? rng.between(0.0, 6.0) : 0;
    const Region target = transformed(two_holes(), angle, {rng.between(-3.0, 3.0), 1});
    const double width = seed % 2 ? 0.8 : 1.7;
    Box box = bounding_box(target);
    box.grow(-0.3);
    compare(target, random_walk(rng, box, 1 + static_cast<int>(seed % 4), 12, seed % 4 == 0 ? 0.4 : 3.0), width);
  }
}

TEST(SweptOracle, RightAnglesOnALattice) {
  // Everything on the tiles' own lines: the case where parity could slip.
  Region target = box_region({0, 0}, {6, 4});
  target.polygons[0].holes.push_back({{1, 1}, {1, 2}, {2, 2}, {2, 1}});
  target.polygons[0].holes.push_back({{2, 2}, {2, 3}, {4, 3}, {4, 2}});
  target.polygons.push_back({{{7, 1}, {8, 1}, {8, 3}, {7, 3}}, {}});
  compare(target, work({{0, 0}, {6, 0}, {6, 4}, {0, 4}, {0, 0}}), 1);
  compare(target, work({{0, 1}, {8, 1}, {8, 2}, {3, 2}, {3, 4}, {3, 2}}), 1);
}

TEST(SweptOracle, CurvesOfShortChords) {
  Polyline spiral;
  for (int k = 0; k < 400; ++k) spiral.push_back(Point(5, 4) + rotated({0.008 * k, 0}, 0.1 * k));
  compare(two_holes(), work(spiral), 0.7);
}

// The bracket of a coarse answer holds the middle of a fine one.
TEST(SweptOracle, FineLiesInCoarse) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Path path = random_walk(rng, bounding_box(two_holes()), 4, 40, 1.0);
    const SweptArea fine = swept_area(two_holes(), 0, 0.3, path, 1e-5),
                    coarse = swept_area(two_holes(), 0, 0.3, path, 0.01);
    EXPECT_LE(fine.coverage.upper - fine.coverage.lower, 1e-5);
    EXPECT_LE(coarse.coverage.lower, fine.coverage.upper);
    EXPECT_GE(coarse.coverage.upper, fine.coverage.lower);
    EXPECT_NEAR(coarse.covered_estimate_m2 / area(two_holes()), fine.coverage.middle(), 2e-4);
  }
}

// Simplified curves: the bounds hold, also where the path trembles, stands still or comes back to where it began.
TEST(SweptOracle, BoundsHoldForCurvesOfManyShortSegments) {
  const double w = 0.7;
  const Region target = box_region({-6, -6}, {6, 6});
  for (const int n : {1000, 30000}) {
    const double sagitta = 3 * (1 - std::cos(kPi / n));
    const SweptArea circle = swept_area(target, 0, w, work(arc({0, 0}, 3, 0, 2 * kPi, n)));
    const double truth = 2 * kPi * 3 * w;
    EXPECT_LE(circle.covered_m2, truth + 1e-9);
    EXPECT_LE(circle.coverage.lower, truth / 144 + 1e-12);
    EXPECT_GE(circle.coverage.upper, (truth - 2 * kPi * 3 * 2 * sagitta) / 144);
    EXPECT_LE(circle.coverage.upper - circle.coverage.lower, 0.001);
    EXPECT_NEAR(circle.union_m2, truth, 2e-4 * truth);
    EXPECT_NEAR(circle.visits_m2, truth + w * w * kPi / 4, 2e-3 * truth);
  }
  for (const auto seed : seeds(20)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const double size = std::pow(10, rng.between(-5.0, 0.5)),
                 tremble = seed % 2 ? std::pow(10, rng.between(-6.0, -2.0)) : 0;
    const int laps = rng.between(1, 4);
    Polyline line;
    for (int k = 0; k <= 1000; ++k) {
      const double t = 2 * kPi * laps * k / 1000;
      line.push_back(Point(size * std::cos(2 * t), size * std::sin(3 * t)) +
                     tremble * Point(rng.between(-1.0, 1.0), rng.between(-1.0, 1.0)));
    }
    const SweptArea coarse = swept_area(target, 0, w, work(line)), fine = swept_area(target, 0, w, work(line), 1e-4);
    EXPECT_LE(fine.coverage.upper - fine.coverage.lower, 1e-4);
    EXPECT_LE(coarse.coverage.lower, fine.coverage.upper);
    EXPECT_GE(coarse.coverage.upper, fine.coverage.lower);
    EXPECT_LE(coarse.covered_m2, fine.coverage.upper * 144 + 1e-9);
    EXPECT_GE(coarse.covered_estimate_m2, kPi * w * w / 4 * 0.999);
    for (const MissedPiece& piece : coarse.missed)  // what is said to be missed is missed
      for (std::size_t part = 0; part < piece.outline.size(); part += 40) {
        const Ring& ring = piece.outline[part];
        const Point p = lerp(ring[0], lerp(ring[1], ring[2], rng.unit()), rng.unit());
        for (std::size_t i = 1; i < line.size(); ++i)
          ASSERT_GE(distance_to_segment(p, line[i - 1], line[i]), w / 2 - 1e-9);
      }
  }
}

/// n points in a square about `centre`: a robot that trembles.
Polyline trembling(Rng& rng, const Point& centre, double half, int n) {
  Polyline line;
  for (int k = 0; k < n; ++k) line.push_back(centre + half * Point(rng.between(-1.0, 1.0), rng.between(-1.0, 1.0)));
  return line;
}

// Thousands of segments in the same few tiles.
TEST(SweptOracle, ThousandsOfOverlappingSegments) {
  Region target = box_region({0, 0}, {4, 3});
  target.polygons[0].holes.push_back({{1, 1}, {1, 2}, {1.7, 2}, {1.7, 1}});
  for (const auto seed : seeds(4)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Path path = seed % 2 ? work(trembling(rng, {1.8, 1.4}, rng.between(0.3, 1.5), 1500))
                               : random_walk(rng, bounding_box(target), 3, 500, 0.3);
    const double w = rng.between(0.4, 1.0);
    const Counts truth = count(target, path, w, w / 12);
    const SweptArea s = swept_area(target, 0, w, path);
    EXPECT_NEAR(s.covered_m2, truth.covered, 0.01 * truth.covered);
    EXPECT_NEAR(s.union_m2, truth.swept, 0.01 * truth.swept);
    EXPECT_NEAR(s.visits_m2, truth.visits, 0.02 * truth.visits);
  }
}

// The bounds hold and are as close as was asked for. Took hours when every segment met every other.
TEST(SweptOracle, OverlappingSegmentsAtAnyCertainty) {
  const Region target = box_region({-4, -4}, {4, 4});
  const Point middle(0.3, 0.2);
  for (const double half : {1.0, 0.3}) {
    SCOPED_TRACE(half);
    Rng rng(17);
    const Path path = work(trembling(rng, middle, half, 3000));
    const SweptArea coarse = swept_area(target, 0, 1, path, 0.01), usual = swept_area(target, 0, 1, path),
                    fine = swept_area(target, 0, 1, path, 1e-5);
    EXPECT_LE(fine.coverage.upper - fine.coverage.lower, 1e-5);
    EXPECT_LE(usual.coverage.upper - usual.coverage.lower, 1e-3);
    for (const SweptArea* s : {&coarse, &usual}) {
      EXPECT_LE(s->coverage.lower, fine.coverage.upper);
      EXPECT_GE(s->coverage.upper, fine.coverage.lower);
      EXPECT_NEAR(s->union_m2, fine.union_m2, 0.01);
      EXPECT_NEAR(s->visits_m2, fine.visits_m2, 0.01 * fine.visits_m2);
    }
    // More than the disc about the square's middle, less than the square grown by the tool.
    EXPECT_GE(fine.coverage.upper * 64, kPi / 4);
    EXPECT_LE(fine.coverage.lower * 64, kPi / 4 + 4 * half + 4 * half * half);
    for (const MissedPiece& piece : usual.missed) EXPECT_GE(distance(piece.at, middle), 0.5);
  }
}

// The curve of a path that trembles is what the path's beginnings cover.
TEST(SweptOracle, CurveOfOverlappingSegments) {
  const Region target = box_region({-2, -2}, {2, 2});
  Rng rng(4);
  Polyline line;
  for (int k = 0; k < 3000; ++k)
    line.push_back(Point(-1.5 + 0.001 * k, 0) + 0.4 * Point(rng.between(-1.0, 1.0), rng.between(-1.0, 1.0)));
  const SweptArea whole = swept_area(target, 0, 1, work(line));
  for (const std::size_t n : {200UL, 900UL, 2100UL}) {
    const Path begin = work(Polyline(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(n)));
    const auto after = std::lower_bound(whole.curve.begin(), whole.curve.end(), begin.length(),
                                        [](const CoveragePoint& p, double m) { return p.path_m < m; });
    ASSERT_NE(after, whole.curve.end());
    EXPECT_NEAR(after->coverage, swept_area(target, 0, 1, begin).coverage.middle(), 2e-3);
  }
}

// No path sweeps more than length * width + a disc.
TEST(SweptOracle, NeverMoreThanItsLengthCanSweep) {
  Rng rng(3);
  for (int k = 0; k < 200; ++k) {
    Path path = random_walk(rng, bounding_box(two_holes()), 1, 1 + k % 9, k % 2 ? 0.2 : 4);
    for (Leg& leg : path.legs) leg.tool = true;
    const double w = 0.3 + 0.01 * (k % 50);
    const SweptArea s = swept_area(two_holes(), 0, w, path);
    EXPECT_LE(s.covered_m2, path.length() * w + kPi * w * w / 4);
    EXPECT_LE(s.union_m2, (path.length() * w + kPi * w * w / 4) * 1.0003);
    EXPECT_GE(s.visits_m2, s.covered_estimate_m2 * 0.998);
  }
}

/// A valid path of a tool no wider than the robot sweeps nothing but target.
TEST(SweptOracle, WithinTheTarget) {
  for (const auto seed : seeds(60)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const double tool = rng.between(0.2, 0.4);
    const Problem p = problem_in(two_holes(), {1, 1}, 0.2, tool);
    const Path path = work(free_walk(p, rng, rng.between(3, 200), 3));
    const SweptArea any = swept_area(p.target(), p.target_excess(), tool, path),
                    within = swept_area(p.target(), p.target_excess(), tool, path, 0.001, MissedOutlines::kept,
                                        Swath::in_target);
    EXPECT_EQ(within.coverage.lower, any.coverage.lower);
    EXPECT_EQ(within.coverage.upper, any.coverage.upper);
    EXPECT_EQ(within.missed.size(), any.missed.size());
    EXPECT_NEAR(within.union_m2, any.union_m2, 1e-6 * any.union_m2);
    // Up to the slivers between the target and its chords, which a path along a wall sweeps.
    EXPECT_NEAR(within.visits_m2, any.visits_m2, 2e-3 * any.visits_m2);
    EXPECT_NEAR(within.covered_estimate_m2, any.covered_estimate_m2, p.target_excess() + 2e-4 * any.covered_m2);
    EXPECT_EQ(within.covered_estimate_m2, within.union_m2);
  }
}

}  // namespace
}  // namespace oxturn
