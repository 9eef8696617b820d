// The whole row: columns, their order, what is empty when, and what holds for every path.
#include "metrics/score.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "shapes.hpp"

namespace oxturn {
namespace {

TEST(Score, ColumnsOfTheDesign) {
  std::vector<std::string> names;
  for (const Metric& m : built_in_metrics()) {
    names.push_back(m.name);
    EXPECT_FALSE(m.help.empty());
    EXPECT_FALSE(m.unit.empty());
  }
  const std::vector<std::string> design{"coverage",
                                        "coverage_lower",
                                        "coverage_upper",
                                        "coverage_of_free",
                                        "target_m2",
                                        "path_m",
                                        "work_m",
                                        "transit_m",
                                        "length_ratio",
                                        "bound_m",
                                        "bound_kind",
                                        "gap",
                                        "overlap",
                                        "revisits",
                                        "promise_coverage",
                                        "path_90_m",
                                        "path_95_m",
                                        "path_99_m",
                                        "mission_90_s",
                                        "mission_95_s",
                                        "mission_99_s",
                                        "missed_pieces",
                                        "missed_largest_m2",
                                        "turns",
                                        "turn_rad",
                                        "curvature_max_per_m",
                                        "curvature_violations",
                                        "cusps",
                                        "clearance_m",
                                        "mission_s",
                                        "tether_limit_m",
                                        "tether_max_m",
                                        "tether_bends_max",
                                        "tether_angle_min_rad",
                                        "tether_angle_mean_rad",
                                        "tether_sharp_fraction",
                                        "tether_crossings",
                                        "tether_entangled",
                                        "stroke_share",
                                        "stroke_error_m",
                                        "fill_share",
                                        "fill_share_reachable",
                                        "spill_m2",
                                        "tool_up_m",
                                        "over_finished_m",
                                        "work_over_finished_m",
                                        "tangent_breaks"};
  EXPECT_EQ(names, design);
}

TEST(Score, LanesOverAHall) {
  // Target: a 10 x 6 box with rounded corners (a disc of the tool's size cannot reach into them).
  const Problem p = problem_in(box_region({0, 0}, {10, 6}), {0.2, 0.2});
  Polyline lanes;
  for (int k = 0; k < 15; ++k) {
    const double y = 0.2 + 0.4 * k;
    lanes.push_back({k % 2 ? 9.8 : 0.2, y});
    lanes.push_back({k % 2 ? 0.2 : 9.8, y});
  }
  const Score s = score(p, work(lanes));
  EXPECT_EQ(s.flaw, "");
  const double target = 60 - (4 - kPi) * 0.2 * 0.2;
  EXPECT_NEAR(s.value("target_m2").value(), target, 1e-3);
  // Missed: between the round ends of neighbouring lanes, on the side where the path does not run along the wall.
  const double missed = 14 * (4 - kPi) * 0.2 * 0.2 / 2;
  EXPECT_NEAR(s.value("coverage").value(), 1 - missed / target, 1e-4);
  EXPECT_LE(s.value("coverage_lower").value(), 1 - missed / target + 1e-9);
  EXPECT_GE(s.value("coverage_upper").value(), 1 - missed / target - 1e-5);
  EXPECT_NEAR(s.value("coverage_of_free").value(), (target - missed) / 60, 1e-4);
  const double length = 15 * 9.6 + 14 * 0.4;
  EXPECT_NEAR(s.value("path_m").value(), length, 1e-9);
  EXPECT_NEAR(s.value("work_m").value(), length, 1e-9);
  EXPECT_EQ(s.value("transit_m").value(), 0);
  EXPECT_NEAR(s.value("length_ratio").value(), length * 0.4 / (target - missed - kPi * 0.04), 1e-3);
  EXPECT_NEAR(s.value("overlap").value(), length * 0.4 / (60 - 4 * (0.04 - kPi * 0.01) - missed) - 1, 1e-3);
  EXPECT_EQ(s.value("turns").value(), 28);
  EXPECT_NEAR(s.value("clearance_m").value(), 0, 1e-9);
  EXPECT_LT(s.value("revisits").value(), 0.05);
}

TEST(Score, RevisitsCountLaps) {
  const Problem p = problem_in(box_region({0, 0}, {10, 0.44}), {0.21, 0.22});
  const Score s = score(p, work({{0.21, 0.22}, {9.79, 0.22}, {0.21, 0.22}, {9.79, 0.22}}));
  // Three passes; each turn's disc is left once only, so every pass after the first begins length * width of visits.
  EXPECT_NEAR(s.value("revisits").value(), 2 * 9.58 * 0.4 / (9.58 * 0.4 + kPi * 0.04), 1e-3);
}

TEST(Score, WhatCannotBeMeasuredIsEmpty) {
  const Problem p = problem_in(two_holes(), {1, 1});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Path& path : {Path{}, work({}), work({{1, 1}, {nan, 2}}), work({{1, 1}, {1e300, -1e300}})}) {
    const Score s = score(p, path);
    EXPECT_NE(s.flaw, "");
    ASSERT_EQ(s.values.size(), built_in_metrics().size());
    for (const MetricValue& v : s.values) EXPECT_FALSE(v.value.has_value());
  }
  EXPECT_FALSE(score(p, work({{1, 1}, {2, 1}})).value("no such metric").has_value());
}

TEST(Score, InvalidPathsAreStillMeasured) {
  const Problem p = problem_in(two_holes(), {1, 1});
  const Score s = score(p, work({{1, 1}, {3, 1}, {3, 7}}));
  EXPECT_NE(s.flaw, "");
  EXPECT_NEAR(s.value("path_m").value(), 8, 1e-12);
  EXPECT_GT(s.value("coverage").value(), 0.02);
  EXPECT_LT(s.value("clearance_m").value(), 0);
}

TEST(Score, NothingToDivideByIsEmpty) {
  const Problem p = problem_in(two_holes(), {1, 1});
  const Score still = score(p, work({{1, 1}, {1, 1}}));
  EXPECT_FALSE(still.value("length_ratio").has_value());
  EXPECT_EQ(still.value("mission_s").value(), 0);
  const Score off = score(p, Path{{Leg{false, {{1, 1}, {5, 1}}}}});
  EXPECT_EQ(off.flaw, "");
  EXPECT_EQ(off.value("coverage_upper").value(),
            off.value("coverage_lower").value() + off.value("coverage_upper").value());
  EXPECT_FALSE(off.value("overlap").has_value());
  const Score jump = score(p, Path{{Leg{true, {{1, 1}, {5, 1}}}, Leg{true, {{1, 5}, {1, 7}}}}});
  EXPECT_FALSE(jump.value("length_ratio").has_value()) << "a path that teleports has no least length";
}

/// What is swept outside the target counts for `overlap`, and is told apart for `revisits`.
TEST(Score, SweptOutsideTheTarget) {
  const Region room = box_region({0, 0}, {10, 4});
  const auto problem_of = [&](double tool, const std::optional<Region>& target_area, std::optional<Tether> tether) {
    Robot robot;
    robot.radius = 0.2;
    robot.tool_width = tool;
    robot.tether = tether;
    Map map{"room", room, "test", "test"};
    map.target_area = target_area;
    return Problem(map, robot, Point(1, 2));
  };
  const Path along = work({{1, 2}, {9, 2}, {9, 1}, {1, 1}}), wall = work({{1, 2}, {1, 0.1}, {9, 0.1}, {9, 2}});
  const auto expect_any = [](const Problem& p, const Path& path) {
    const SweptArea s = swept_area(p.target(), p.target_excess(), p.robot().tool_width, path);
    const Score scored = score(p, path);
    EXPECT_NEAR(*scored.value("overlap"), std::max(0.0, s.work_m2 / s.union_m2 - 1), 1e-9);
    EXPECT_NEAR(*scored.value("revisits"), std::max(0.0, s.visits_m2 / s.covered_estimate_m2 - 1), 1e-9);
  };
  expect_any(problem_of(3, std::nullopt, std::nullopt), along);        // a tool that reaches into the walls
  expect_any(problem_of(0.4, box_region({0, 0}, {5, 4}), {}), along);  // beyond the target area
  expect_any(problem_of(0.4, std::nullopt, std::nullopt), wall);       // into a wall
  expect_any(problem_of(0.4, std::nullopt, Tether{0, 5}), along);      // beyond the tether's reach
}

TEST(Score, LengthRatioNeverBelowOne) {
  const Problem p = problem_in(two_holes(), {1, 1}, 0.1, 0.4);
  Rng rng(21);
  int measured = 0;
  for (int k = 0; k < 150; ++k) {
    Path path = random_walk(rng, Box{{0.2, 0.2}, {9.8, 7.8}}, 1 + k % 3, 1 + k % 7, k % 2 ? 6 : 0.3);
    if (k % 5 == 0) path = work({{1, 1}, {1 + 0.05 * k, 1}});  // the best there is: a straight line
    const auto ratio = score(p, path).value("length_ratio");
    if (!ratio) continue;
    ++measured;
    EXPECT_GE(*ratio, 1) << k;
    if (k % 5 == 0) { EXPECT_NEAR(*ratio, 1, k > 10 ? 0.02 : 1) << k; }
  }
  EXPECT_GT(measured, 100);
}

TEST(Score, ShiftAndRotation) {
  Rng rng(5);
  const Path path = random_walk(rng, Box{{0.5, 0.5}, {9.5, 1.5}}, 4, 10, 2);
  const Point start = path.legs[0].points[0];
  const Score base = score(problem_in(two_holes(), start), path);
  for (const auto& [angle, shift] : {std::pair<double, Point>{0, {1e5, -1e5}}, {1.1, {-2, 3}}}) {
    const Problem p = problem_in(transformed(two_holes(), angle, shift), rotated(start, angle) + shift);
    const Score s = score(p, moved(path, angle, shift));
    EXPECT_EQ(s.flaw, base.flaw);
    for (std::size_t i = 0; i < s.values.size(); ++i) {
      ASSERT_EQ(s.values[i].value.has_value(), base.values[i].value.has_value());
      if (!s.values[i].value) continue;
      EXPECT_NEAR(*s.values[i].value, *base.values[i].value, 2e-3 * (0.1 + std::abs(*base.values[i].value)))
          << s.values[i].name;
    }
  }
}

TEST(Score, SameBytesTwice) {
  Rng rng(6);
  const Path path = random_walk(rng, Box{{0.5, 0.5}, {9.5, 1.5}}, 4, 30, 2);
  const Problem p = problem_in(two_holes(), path.legs[0].points[0]);
  EXPECT_EQ(score(p, path).values, score(p, path).values);
}

}  // namespace
}  // namespace oxturn
