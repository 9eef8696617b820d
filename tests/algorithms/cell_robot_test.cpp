#include "algorithms/lattice/cell_robot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lattice/cell_map.hpp"
#include "tests/support/drawn.hpp"

namespace oxturn {
namespace {

TEST(CellRobot, FeelsNearCellsOnly) {
  const Problem problem = drawn({"......", ".S#...", "......"});
  const GridGraph graph = grid_at_start(problem, 1);
  CellRobot robot = robot_at_start(problem, graph);
  EXPECT_TRUE(robot.free({-1, 0}));
  EXPECT_FALSE(robot.free({1, 0}));
  EXPECT_TRUE(robot.free({1, 1}));
  EXPECT_FALSE(robot.passable({0, 0}, kEast));
  EXPECT_TRUE(robot.passable({0, 1}, kEast));
  EXPECT_THROW((void)robot.free({2, 0}), std::logic_error);
  EXPECT_THROW((void)robot.free({0, -2}), std::logic_error);
  EXPECT_THROW((void)robot.passable({1, 1}, kEast), std::logic_error);
  EXPECT_FALSE(robot.step(kEast));
  EXPECT_EQ(robot.at(), Cell{});
  EXPECT_TRUE(robot_at_start(problem, graph, 3).free({3, 1}));
}

TEST(CellRobot, DrivesOneSegmentForEachRun) {
  const Problem problem = drawn({".....", ".....", "S...."});
  const GridGraph graph = grid_at_start(problem, 1);
  CellRobot robot = robot_at_start(problem, graph);
  for (const Direction d : {kEast, kEast, kNorth, kWest}) EXPECT_TRUE(robot.step(d));
  EXPECT_TRUE(robot.step(kWest, false));
  EXPECT_EQ(robot.at(), (Cell{0, 1}));
  EXPECT_EQ(robot.steps(), 5u);
  const Path path = robot.take();
  ASSERT_EQ(path.legs.size(), 2u);
  EXPECT_EQ(path.legs[0].points, (Polyline{{0.5, 0.5}, {2.5, 0.5}, {2.5, 1.5}, {1.5, 1.5}}));
  EXPECT_EQ(path.legs[1].points, (Polyline{{1.5, 1.5}, {0.5, 1.5}}));
  EXPECT_FALSE(path.legs[1].tool);
}

TEST(CellRobot, AnEnclosedStartIsOneSentence) {
  const Problem problem = drawn({"S"});
  const GridGraph graph = grid_at_start(problem, 1);
  EXPECT_THAT([&] { (void)robot_at_start(problem, graph); },
              testing::ThrowsMessage<Infeasible>(testing::HasSubstr("smaller cell_size")));
}

TEST(CellRobot, EntersALatticeUnderTheStartOrByTheShortestPath) {
  const Problem problem = drawn({"..#..", "S.#..", "....."});
  const auto here = entry_from_start(problem, GridGraph(problem.configuration_space(), 1, 0, {0, 0}, 5, 3));
  ASSERT_TRUE(here);
  EXPECT_EQ(here->cell, (Cell{0, 1}));
  // This lattice covers the cells on the right only.
  const auto far = entry_from_start(problem, GridGraph(problem.configuration_space(), 1, 0, {3, 0}, 2, 3));
  ASSERT_TRUE(far);
  EXPECT_EQ(far->cell, Cell{});
  EXPECT_GT(far->path.size(), 2u);
  const auto none = entry_from_start(problem, GridGraph(problem.configuration_space(), 1, 0, {9, 9}, 2, 2));
  EXPECT_FALSE(none);
}

TEST(CellMap, GrowsWhereItIsWritten) {
  CellMap<int> grown;
  std::map<std::pair<int, int>, int> truth;
  Rng rng(1);
  Cell at;
  for (int k = 1; k < 5000; ++k) {
    at = neighbour(at, kAllDirections[rng.below(4)]);
    if (k % 1000 == 0) at.i += 100;
    grown[at] = truth[{at.i, at.j}] = k;
  }
  for (int i = -200; i < 600; ++i)
    for (int j = -200; j < 200; ++j) {
      const auto known = truth.find({i, j});
      ASSERT_EQ(grown.get({i, j}), known == truth.end() ? 0 : known->second) << i << " " << j;
    }
}

}  // namespace
}  // namespace oxturn
