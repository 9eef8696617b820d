// Areas that a pencil knows.
#include "metrics/swept_area.hpp"

#include <gtest/gtest.h>

#include "shapes.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

const double kDisc = kPi / 4;  // of a tool one metre wide

void expect_bracket(const SweptArea& s, double target_m2, double truth_m2) {
  EXPECT_LE(s.coverage.lower, truth_m2 / target_m2 + 1e-12);
  EXPECT_GE(s.coverage.upper, truth_m2 / target_m2 - 1e-12);
  EXPECT_LE(s.coverage.upper - s.coverage.lower, 0.001);
  EXPECT_LE(s.covered_m2, truth_m2 + 1e-12 * target_m2);
  EXPECT_NEAR(s.covered_estimate_m2, truth_m2, 2e-4 * truth_m2);
}

TEST(SweptArea, OneStraightSwath) {
  for (const double x : {0.0, 0.25, 0.31}) {
    const SweptArea s = swept_area(box_region({-5, -5}, {15, 5}), 0, 1, work({{x, 0.1}, {7 + x, 0.1}}));
    const double truth = 7 + kDisc;
    expect_bracket(s, 200, truth);
    EXPECT_NEAR(s.union_m2, truth, 1e-4);
    EXPECT_NEAR(s.work_m2, 7, 1e-12);
    EXPECT_NEAR(s.visits_m2, truth, 1e-9);
  }
}

TEST(SweptArea, TighterWhenAsked) {
  const SweptArea s = swept_area(box_region({-1, -1}, {3, 1}), 0, 1, work({{0, 0}, {2, 0.3}}), 1e-5);
  EXPECT_LE(s.coverage.upper - s.coverage.lower, 1e-5);
  const double truth = std::hypot(2, 0.3) + kDisc;
  EXPECT_LE(s.covered_m2, truth);
  EXPECT_LE(s.coverage.lower, truth / 8);
  EXPECT_GE(s.coverage.upper, truth / 8);
}

TEST(SweptArea, StandingStillIsADisc) {
  const SweptArea s = swept_area(box_region({-5, -5}, {5, 5}), 0, 1, work({{0.3, 0.2}, {0.3, 0.2}}));
  expect_bracket(s, 100, kDisc);
  EXPECT_NEAR(s.union_m2, kDisc, 1e-4);
  EXPECT_NEAR(s.visits_m2, kDisc, 1e-9);
}

TEST(SweptArea, RightAngle) {
  // Two arms of 5, whose swaths share a quarter square inside and a disc's quarter outside the corner.
  const SweptArea s = swept_area(box_region({-5, -5}, {15, 15}), 0, 1, work({{0, 0}, {5, 0}, {5, 5}}));
  const double truth = 2 * 5 + kDisc - 0.25 + kDisc / 4;
  expect_bracket(s, 400, truth);
  EXPECT_NEAR(s.union_m2, truth, 2e-4);
  EXPECT_NEAR(s.visits_m2, 10 + kDisc, 1e-9);  // the second arm begins 5 m2 of visits
}

TEST(SweptArea, CrossOfTwoLegsOverlapsByASquare) {
  Path path{{Leg{true, {{-5, 0}, {5, 0}}}, Leg{false, {{5, 0}, {0, -5}}}, Leg{true, {{0, -5}, {0, 5}}}}};
  const SweptArea s = swept_area(box_region({-10, -10}, {10, 10}), 0, 1, path);
  const double each = 10 + kDisc;
  expect_bracket(s, 400, 2 * each - 1);
  EXPECT_NEAR(s.work_m2, 20, 1e-12);
  EXPECT_NEAR(s.union_m2, 2 * each - 1, 4e-4);
  EXPECT_NEAR(s.visits_m2, 2 * each, 1e-9);
}

TEST(SweptArea, LegsThatJoinAreOneStretch) {
  Path path{{Leg{true, {{-5, 0}, {0, 0}}}, Leg{true, {{0, 0}, {5, 0}}}}};
  const SweptArea s = swept_area(box_region({-10, -10}, {10, 10}), 0, 1, path);
  EXPECT_NEAR(s.visits_m2, 10 + kDisc, 1e-9);
  EXPECT_NEAR(s.work_m2, 10, 1e-12);
  EXPECT_NEAR(s.union_m2, 10 + kDisc, 4e-4);
}

TEST(SweptArea, ThereAndBack) {
  const SweptArea s = swept_area(box_region({-5, -5}, {15, 5}), 0, 1, work({{0, 0}, {7, 0}, {0, 0}}));
  EXPECT_NEAR(s.union_m2, 7 + kDisc, 1e-4);
  // On the path back begin the visits of all that is not in the last disc.
  EXPECT_NEAR(s.visits_m2, 7 + kDisc + 7, 1e-9);
}

TEST(SweptArea, WholeRectangle) {
  // Lanes from wall to wall, drawn over the edge: everything is covered, and it says exactly so.
  Polyline lanes;
  for (int k = 0; k <= 8; ++k) {
    const double y = 0.5 + k;
    lanes.push_back({k % 2 ? 13 : -1, y * 0.99});
    lanes.push_back({k % 2 ? -1 : 13, y * 0.99});
  }
  const SweptArea s = swept_area(box_region({0, 0}, {12, 8}), 0, 1, work(lanes));
  EXPECT_EQ(s.coverage.lower, 1);
  EXPECT_EQ(s.coverage.upper, 1);
  EXPECT_NEAR(s.covered_m2, 96, 1e-9);
}

TEST(SweptArea, TargetWithHolesNotCovered) {
  const Region target = two_holes();
  const SweptArea none = swept_area(target, 0, 0.4, Path{{Leg{false, {{1, 1}, {9, 1}}}}});
  EXPECT_EQ(none.coverage.lower, 0);
  EXPECT_EQ(none.coverage.upper, 0);
  EXPECT_EQ(none.union_m2, 0);
  // A tool as large as the map covers all of it, whatever its shape.
  const SweptArea all = swept_area(target, 0, 30, work({{5, 4}, {6, 4}}));
  EXPECT_EQ(all.coverage.lower, 1);
  EXPECT_NEAR(all.covered_m2, area(target), 1e-9);
  EXPECT_NEAR(all.visits_m2, area(target), 2e-3 * area(target));
}

TEST(SweptArea, SumOfTargetOverTilesIsItsArea) {
  // Fine lanes over everything: the tiles' target areas must add up to the polygon's, at any angle and position.
  for (const double angle : {0.0, 0.3, kPi / 4, 2.1}) {
    for (const Point& shift : {Point(0, 0), Point(0.137, -3.77)}) {
      const Region target = transformed(two_holes(), angle, shift);
      const Box box = bounding_box(target);
      Polyline lanes;
      for (double y = box.low.y() - 0.1; y < box.high.y() + 0.1; y += 0.19) {
        lanes.push_back({box.low.x() - 0.2, y});
        lanes.push_back({box.high.x() + 0.2, y});
      }
      const SweptArea s = swept_area(target, 0, 0.4, work(lanes));
      EXPECT_NEAR(s.covered_m2, area(target), 1e-10 * area(target));
      EXPECT_EQ(s.coverage.lower, 1);
    }
  }
}

TEST(SweptArea, CoverageAloneIsTheSame) {
  for (const auto seed : seeds(20)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Path path = random_walk(rng, Box{{0, 0}, {10, 8}}, 5, 20, 3);
    const Interval alone = coverage_of(two_holes(), 0.01, 0.4, path);
    const SweptArea s = swept_area(two_holes(), 0.01, 0.4, path);
    EXPECT_EQ(alone.lower, s.coverage.lower);
    EXPECT_EQ(alone.upper, s.coverage.upper);
  }
}

TEST(SweptArea, DoubtAboutTheTargetWidensTheInterval) {
  const Path path = work({{1, 1}, {9, 1}});
  const SweptArea sure = swept_area(two_holes(), 0, 0.4, path), unsure = swept_area(two_holes(), 0.02, 0.4, path);
  const double a = area(two_holes());
  EXPECT_LT(unsure.coverage.lower, sure.coverage.lower);
  EXPECT_LE(unsure.coverage.lower, sure.coverage.lower * a / (a + 0.02) + 1e-5);
  EXPECT_GE(unsure.coverage.upper, (sure.coverage.lower * a + 0.02) / (a + 0.02));
}

TEST(SweptArea, StraightOnPointsChangeNothing) {
  Polyline many;
  for (int k = 0; k <= 1000; ++k) many.push_back(Point(1, 1) + k * Point(0.0071, 0.0013));
  const SweptArea fine = swept_area(two_holes(), 0, 0.4, work(many));
  const SweptArea two = swept_area(two_holes(), 0, 0.4, work({many.front(), many.back()}));
  EXPECT_NEAR(fine.covered_m2, two.covered_m2, 1e-8);
  EXPECT_NEAR(fine.visits_m2, two.visits_m2, 1e-8);
}

TEST(SweptArea, ShiftRotateScale) {
  Rng rng(7);
  const Region target = two_holes();
  const Path path = random_walk(rng, bounding_box(target), 5, 30, 1.5);
  const SweptArea base = swept_area(target, 0, 0.4, path);
  const auto same = [&](const SweptArea& s, double scale2, double tolerance) {
    EXPECT_NEAR(s.covered_estimate_m2 / scale2, base.covered_estimate_m2, tolerance * base.covered_estimate_m2);
    EXPECT_NEAR(s.union_m2 / scale2, base.union_m2, tolerance * base.union_m2);
    EXPECT_NEAR(s.work_m2 / scale2, base.work_m2, tolerance * base.work_m2);
    EXPECT_NEAR(s.visits_m2 / scale2, base.visits_m2, 10 * tolerance * base.visits_m2);
    EXPECT_LE(s.coverage.lower, base.coverage.upper);
    EXPECT_GE(s.coverage.upper, base.coverage.lower);
  };
  const Point far(1e6, -1e6);
  same(swept_area(transformed(target, 0, far), 0, 0.4, moved(path, 0, far)), 1, 1e-7);
  same(swept_area(transformed(target, 0.7, {3, 1}), 0, 0.4, moved(path, 0.7, {3, 1})), 1, 3e-4);
  Region large = target;
  for (Polygon& p : large.polygons) {
    for (Point& q : p.outer) q *= 1000;
    for (Ring& h : p.holes)
      for (Point& q : h) q *= 1000;
  }
  same(swept_area(large, 0, 400, moved(path, 0, {0, 0}, 1000)), 1e6, 1e-7);
}

TEST(SweptArea, HostileInput) {
  const Region target = two_holes();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(swept_area(target, 0, 0.4, work({{1, 1}, {nan, 1}})), std::invalid_argument);
  EXPECT_THROW(swept_area(target, 0, 0, work({{1, 1}, {2, 1}})), std::invalid_argument);
  EXPECT_THROW(swept_area({}, 0, 0.4, work({{1, 1}, {2, 1}})), std::invalid_argument);
  EXPECT_THROW(swept_area(target, 0, 0.4, work({{1, 1}, {1e300, 1}})), std::invalid_argument);
  // No end in sight: 5 * 10^9 rows of tiles; 5 * 10^9 tiles along the path.
  EXPECT_THROW(swept_area(box_region({0, 0}, {1, 1e9}), 0, 0.4, work({{0.5, 1}, {0.5, 2}})), std::invalid_argument);
  EXPECT_THROW(coverage_of(box_region({0, 0}, {1e9, 1}), 0, 0.4, work({{0, 0.5}, {1e9, 0.5}})), std::invalid_argument);
  EXPECT_EQ(swept_area(target, 0, 0.4, Path{}).coverage.upper, 0);
  EXPECT_EQ(swept_area(target, 0, 0.4, work({})).coverage.upper, 0);
  // A mad line is cut to the map: quick, and what it sweeps of the map counts.
  const SweptArea mad = swept_area(box_region({0, 0}, {10, 8}), 0, 0.4, work({{-1e9, 4}, {1e9, 4}}));
  EXPECT_NEAR(mad.covered_m2, 4, 1e-6);
  EXPECT_EQ(swept_area(target, 0, 0.4, work({{1e9, 1e9}, {1e9 + 1, 1e9}})).union_m2, 0);
}

// A path that keeps below the straight line between its ends, by less than its chains may be simplified, and touches it
// now and then only: the lower bound must not take the straight line for the path.
TEST(SweptArea, SimplifiedChainsKeepTheLowerBound) {
  constexpr double kLength = 1000, kPeriod = 10, kTip = 0.04;
  for (const double depth : {1e-5, 3e-5, 6e-5, 1e-4}) {
    Polyline line;
    for (double x = 0; x < kLength; x += kPeriod)
      line.insert(line.end(), {{x, 0.4}, {x + kTip, 0.4 - depth}, {x + kPeriod - kTip, 0.4 - depth}});
    line.push_back({kLength, 0.4});
    const SweptArea s = swept_area(box_region({0, 0}, {kLength, 2}), 0, 1, work(line));
    // Up to 0.9 - depth everywhere, but at the tips and within half a tool width of a tip's disc.
    const double tips = kLength / kPeriod * 4 * (kTip + std::sqrt(depth)) * depth;
    const double covered = kLength * (0.9 - depth) + tips;
    EXPECT_LE(s.coverage.lower, covered / (2 * kLength)) << depth;
    EXPECT_GE(s.coverage.upper, (covered - tips) / (2 * kLength) - 1e-3) << depth;
  }
}

}  // namespace
}  // namespace oxturn
