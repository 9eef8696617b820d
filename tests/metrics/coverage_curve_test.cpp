// Covered share of the target over path length, against a grid of points.
#include <gtest/gtest.h>

#include "metrics/score.hpp"
#include "shapes.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

double interpolated(const std::vector<CurvePoint>& curve, double path_m) {
  for (std::size_t i = 1; i < curve.size(); ++i)
    if (path_m <= curve[i].path_m) {
      const double t = (path_m - curve[i - 1].path_m) / (curve[i].path_m - curve[i - 1].path_m);
      return curve[i - 1].coverage + t * (curve[i].coverage - curve[i - 1].coverage);
    }
  return curve.back().coverage;
}

/// Metres driven until the tool first reaches x, by the roots of |p(t) - x| = r; infinity: never.
double first_reached(const Path& path, const Point& x, double r) {
  double driven = 0;
  for (const Leg& leg : path.legs)
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      const Point &a = leg.points[i - 1], &b = leg.points[i];
      const double length = distance(a, b);
      if (leg.tool && length > 0 && distance_to_segment(x, a, b) <= r) {
        const Point u = (b - a) / length;
        const double half = std::sqrt(r * r - std::pow(cross(u, x - a), 2));
        return driven + std::max(0.0, u.dot(x - a) - half);
      }
      driven += length;
    }
  return std::numeric_limits<double>::infinity();
}

/// Positions at which points spread evenly over the target are reached first, ascending.
std::vector<double> first_reached(const Region& target, const Path& path, double width, double pitch) {
  std::vector<double> all;
  Rng rng(7);
  const Box box = bounding_box(target);
  for (double y = box.low.y(); y < box.high.y(); y += pitch)
    for (double x = box.low.x(); x < box.high.x(); x += pitch) {
      const Point p = Point(x, y) + pitch * Point(rng.unit(), rng.unit());
      if (contains(target, p)) all.push_back(first_reached(path, p, width / 2));
    }
  std::sort(all.begin(), all.end());
  return all;
}

TEST(CoverageCurve, AsByAGridOfPoints) {
  for (const auto seed : seeds(12)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Path path = random_walk(rng, Box{{0.5, 0.5}, {9.5, 7.5}}, 1 + static_cast<int>(seed % 4), 30, 6);
    const double width = seed % 2 ? 0.8 : 1.5;
    const SweptArea s = swept_area(two_holes(), 0, width, path);
    const std::vector<double> truth = first_reached(two_holes(), path, width, 0.05);
    double last = 0;
    for (const CoveragePoint& p : s.curve) {
      EXPECT_GE(p.coverage, last);
      last = p.coverage;
    }
    EXPECT_EQ(last, s.coverage.middle());
    EXPECT_EQ(s.curve.back().path_m, path.length());
    for (const double share : {0.1, 0.3, 0.5, 0.7, 0.8, 0.9, 0.95}) {
      const double metres = truth[static_cast<std::size_t>(share * static_cast<double>(truth.size()))];
      if (!std::isfinite(metres) || share > last - 0.01) continue;
      const auto reached =
          std::find_if(s.curve.begin(), s.curve.end(), [&](const auto& p) { return p.coverage >= share; });
      // The grid itself errs by about a thousandth of the coverage; where the curve is flat that is more path.
      const auto near = [&](double q) {
        const auto i = static_cast<std::size_t>(std::clamp(q, 0.0, 0.9999) * static_cast<double>(truth.size()));
        return std::min(truth[i], path.length());
      };
      const double slack = 0.01 * metres + 0.02;
      EXPECT_GE(reached->path_m, near(share - 0.002) - slack) << share;
      EXPECT_LE(reached->path_m, near(share + 0.002) + slack) << share;
    }
  }
}

TEST(CoverageCurve, LanesFillAHallEvenly) {
  const Problem p = problem_in(box_region({0, 0}, {10, 4}), {0.2, 0.2});
  Polyline lanes;
  for (int k = 0; k < 10; ++k) {
    lanes.push_back({k % 2 ? 9.8 : 0.2, 0.2 + 0.4 * k});
    lanes.push_back({k % 2 ? 0.2 : 9.8, 0.2 + 0.4 * k});
  }
  const Path path = work(lanes);
  const Score s = score(p, path);
  EXPECT_LE(s.curve.size(), 200u);
  EXPECT_EQ(s.curve.front().coverage, 0);
  EXPECT_EQ(s.curve.back().coverage, *s.value("coverage"));
  EXPECT_EQ(s.curve.back().path_m, *s.value("path_m"));
  EXPECT_NEAR(s.curve.back().mission_s, *s.value("mission_s"), 1e-6);
  for (int lane = 1; lane < 10; ++lane) EXPECT_NEAR(interpolated(s.curve, 10.0 * lane), lane / 10.0, 0.006);
  EXPECT_NEAR(*s.value("path_90_m"), 90, 0.5);
  EXPECT_NEAR(*s.value("path_95_m"), 95, 0.5);
  EXPECT_FALSE(score(p, work({{0.2, 0.2}, {9.8, 0.2}})).value("path_90_m").has_value());
  EXPECT_FALSE(score(p, work({{0.2, 0.2}, {9.8, 0.2}})).value("mission_90_s").has_value());
  const MissionClock clock(p, path);
  EXPECT_NEAR(*s.value("mission_95_s"), clock.at(*s.value("path_95_m")), 1e-9);
}

TEST(CoverageCurve, NothingCoveredIsFlat) {
  const SweptArea s = swept_area(two_holes(), 0, 0.4, Path{{Leg{false, {{1, 1}, {9, 1}}}}});
  ASSERT_EQ(s.curve.size(), 2u);
  EXPECT_EQ(s.curve[1].path_m, 8);
  EXPECT_EQ(s.curve[1].coverage, 0);
}

}  // namespace
}  // namespace oxturn
