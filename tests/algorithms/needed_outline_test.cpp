// Lanes with as much of the outline as coverage needs.
#include <gtest/gtest.h>

#include "coverage_oracle.hpp"
#include "metrics/score.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

Settings needed(double coverage) { return {{"outline", std::string("needed")}, {"coverage", coverage}}; }

double certified(const Problem& problem, const Path& path) {
  return score(problem, path, {}).value("coverage_lower").value();
}

constexpr const char* kPlanners[] = {"boustrophedon", "trapezoid", "zigzag", "oarp"};

TEST(NeededOutline, ReachesTheCoverage) {
  std::size_t next = 0;
  for (const auto seed : seeds(1))
    for (const Problem& p : sample_problems(seed)) {
      const std::string planner = kPlanners[next++ % std::size(kPlanners)];
      SCOPED_TRACE(planner + " on " + p.map().source);
      for (const double coverage : {0.97, 0.99, 0.999}) {
        const Path path = plan(planner, p, needed(coverage));
        expect_valid(p, path);
        EXPECT_GE(certified(p, path), coverage);
      }
      const Path all = plan(planner, p, needed(1));
      expect_valid(p, all);
      EXPECT_GE(certified(p, all), 0.9997);
    }
}

TEST(NeededOutline, IsNoLongerThanTheWholeOutline) {
  std::size_t next = 0;
  double sum = 0, count = 0;
  for (const auto seed : seeds(4))
    for (const Problem& p : sample_problems(seed)) {
      const std::string planner = kPlanners[next++ % std::size(kPlanners)];
      SCOPED_TRACE(planner + " on " + p.map().source);
      const double whole = plan(planner, p).length();
      EXPECT_LE(plan(planner, p, needed(1)).length(), whole * (1 + 1e-9));
      const double part = plan(planner, p, needed(0.99)).length();
      EXPECT_LE(part, whole * (1 + 1e-9));
      sum += part / whole;
      ++count;
    }
  EXPECT_LT(sum / count, 0.98);
}

// Lanes from wall to wall need a lap along the two walls beside them only: along the other two, cusps of
// (1 - pi / 4) / 2 tool widths for every second lane stay uncovered.
TEST(NeededOutline, ARectangleNeedsTheWallsAlongTheLanes) {
  const Robot robot = disc(0.2, 0.4);
  const Problem p(Map{"hall", box_region({0, 0}, {24, 12}), "", ""}, robot, Point(1, 1));
  const double whole = plan("boustrophedon", p).length();
  const Path path = plan("boustrophedon", p, needed(0.99));
  const double end_walls = 2 * 12, half_of_them_by_longer_lanes = end_walls / 2;
  EXPECT_NEAR(whole - path.length(), end_walls - half_of_them_by_longer_lanes, 4);
  const double cusps = (1 - kPi / 4) / 2 * 0.4 * end_walls / 2 / area(p.target());
  EXPECT_NEAR(1 - certified(p, path), cusps, 0.002);
}

TEST(NeededOutline, TheCoverageIsASetting) {
  const Problem p(Map{"hall", box_region({0, 0}, {8, 6}), "", ""}, disc(0.2, 0.4), Point(1, 1));
  EXPECT_THROW(plan("boustrophedon", p, needed(0)), std::invalid_argument);
  EXPECT_THROW(plan("boustrophedon", p, needed(1.1)), std::invalid_argument);
  const double truth = plan("boustrophedon", p, {{"outline", true}}).length();
  EXPECT_EQ(truth, plan("boustrophedon", p).length());
  EXPECT_EQ(plan("boustrophedon", p, {{"outline", false}}).length(),
            plan("boustrophedon", p, {{"outline", std::string("false")}}).length());
}

}  // namespace
}  // namespace oxturn
