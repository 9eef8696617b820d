#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "algorithms/coverage_planner.hpp"
#include "maps/generators.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/planners.hpp"

namespace oxturn {
namespace {

using Cell = std::pair<int, int>;

Path plan_stc(const Problem& problem, const Settings& settings = {}) {
  Context context(1);
  return built_in_planner("stc", settings)->plan(problem, context);
}

// The sub-cells on a leg with the tool on, in driving order, counted from the leg's first point: nothing but the side
// is taken from the planner's grid.
std::vector<Cell> cells_driven(const Polyline& line, double side) {
  std::vector<Cell> cells;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Point d = line[k + 1] - line[k];
    const int steps = static_cast<int>(std::lround(d.norm() / side));
    EXPECT_NEAR(d.norm(), steps * side, 1e-9) << "a segment is not a whole number of cells long";
    for (int s = 0; s < steps; ++s) {
      const Point at = line[k] + d * (double(s) / steps) - line[0];
      cells.push_back({static_cast<int>(std::lround(at.x() / side)), static_cast<int>(std::lround(at.y() / side))});
    }
  }
  return cells;
}

// Coarse cells by their definition: the square through four sub-cell centres lies in configuration space, and
// neighbours are connected by two segments in it. Flood fill from the coarse cell with lower left centre `corner`.
std::size_t sub_cells_reachable(const Problem& problem, const Point& corner, double side) {
  const EdgeIndex& space = problem.walls();
  const auto at = [&](int i, int j) { return Point(corner + side * Point(i, j)); };  // sub-cell centres
  const auto free = [&](const Cell& c) {
    const int i = 2 * c.first, j = 2 * c.second;
    return space.contains(at(i, j), at(i + 1, j)) && space.contains(at(i + 1, j), at(i + 1, j + 1)) &&
           space.contains(at(i + 1, j + 1), at(i, j + 1)) && space.contains(at(i, j + 1), at(i, j));
  };
  const auto connected = [&](const Cell& c, int di, int dj) {
    const int i = 2 * c.first, j = 2 * c.second;
    for (int k = 0; k < 2; ++k) {
      const Point a = di != 0 ? at(i + (di > 0), j + k) : at(i + k, j + (dj > 0));
      const Point b = di != 0 ? at(i + (di > 0) + di, j + k) : at(i + k, j + (dj > 0) + dj);
      if (!space.contains(a, b)) return false;
    }
    return free({c.first + di, c.second + dj});
  };
  std::set<Cell> seen{{0, 0}};
  std::vector<Cell> queue{{0, 0}};
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const Cell c = queue[k];
    for (const Cell& step : {Cell{1, 0}, Cell{0, 1}, Cell{-1, 0}, Cell{0, -1}})
      if (connected(c, step.first, step.second) && seen.insert({c.first + step.first, c.second + step.second}).second)
        queue.push_back({c.first + step.first, c.second + step.second});
  }
  return 4 * seen.size();
}

// The path is closed, drives each sub-cell once, and as many of them as a flood fill reaches.
void expect_round(const Problem& problem, const Polyline& line, double side) {
  EXPECT_LT(distance(line.front(), line.back()), 1e-9) << "not closed";
  const std::vector<Cell> cells = cells_driven(line, side);
  const std::set<Cell> once(cells.begin(), cells.end());
  EXPECT_EQ(once.size(), cells.size()) << "a sub-cell is driven twice";
  EXPECT_NEAR(length(line), side * static_cast<double>(cells.size()), 1e-6);
  // Whole coarse cells only: one of the four possible pairings of sub-cells fits.
  int fits = 0;
  for (const Cell& offset : {Cell{0, 0}, Cell{-1, 0}, Cell{0, -1}, Cell{-1, -1}}) {
    std::map<Cell, int> quarters;
    for (const Cell& c : cells) ++quarters[{(c.first - offset.first) >> 1, (c.second - offset.second) >> 1}];
    const bool whole = std::all_of(quarters.begin(), quarters.end(), [](const auto& q) { return q.second == 4; });
    if (!whole) continue;
    ++fits;
    const Point corner = line.front() + side * Point(offset.first, offset.second);
    if (sub_cells_reachable(problem, corner, side) == cells.size()) return;
  }
  ADD_FAILURE() << fits << " pairings of sub-cells fit, none with as many cells as a flood fill reaches ("
                << cells.size() << " driven)";
}

TEST(Stc, DrivesEachSubCellThatAFloodFillReachesOnce) {
  for (const char* generator : {"rectangle", "polygon", "clutter", "rooms", "cave"})
    for (std::uint64_t seed = 1; seed <= 12; ++seed)
      for (const char* tree : {"bfs", "dfs", "minimum-turn", "random", "weighted"}) {
        SCOPED_TRACE(fmt::format("{} --seed {} tree={}", generator, seed, tree));
        const Problem problem(generate(generator, {}, seed), Robot{});
        const double side = 0.4 / std::sqrt(2.0);
        const Path path = plan_stc(problem, {{"tree", std::string(tree)}, {"components", std::string("start")}});
        int rounds = 0;
        for (const Leg& leg : path.legs) {
          if (!leg.tool) continue;
          ++rounds;
          expect_round(problem, leg.points, side);
        }
        EXPECT_EQ(rounds, 1);
        EXPECT_LT(distance(path.legs.front().points.front(), problem.start()), 1e-12);
      }
}

TEST(Stc, CoversASquareThatFitsExactly) {
  // 4 m x 4 m, square tool as wide as the robot: 10 x 10 cells of 0.4 m touch the walls on all sides.
  Robot robot;
  const Problem problem({"square", box_region({0, 0}, {4.00001, 4.00001}), "test", ""}, robot, Point(1, 1));
  const Path path = plan_stc(problem, {{"cell_size", 0.4}});
  EXPECT_NEAR(path.length(true), 100 * 0.4, 1e-6);
}

TEST(Stc, GoesOnToOtherComponentsByDefault) {
  // Two rooms connected by a corridor that is too narrow for a coarse cell.
  Polygon rooms;
  rooms.outer = {{0, 0},  {4, 0}, {4, 1.8}, {6, 1.8}, {6, 0}, {10, 0},
                 {10, 4}, {6, 4}, {6, 2.3}, {4, 2.3}, {4, 4}, {0, 4}};
  const Problem problem({"rooms", {{rooms}}, "test", ""}, Robot{}, Point(2, 2));
  const auto rounds = [&](const char* components) {
    int n = 0;
    for (const Leg& leg : plan_stc(problem, {{"components", std::string(components)}}).legs) n += leg.tool;
    return n;
  };
  EXPECT_EQ(rounds("start"), 1);
  EXPECT_EQ(rounds("all"), 3);  // the second room is a branch of the first one's round
}

// Thousands of components of which the lattice connects few: one closed path, whatever lies between them.
TEST(Stc, IsOneClosedPathThroughAllComponents) {
  Robot robot;
  robot.radius = 0.19;
  for (const double size : {12.0, 40.0, 90.0})
    for (const std::uint64_t seed : {1, 2, 3}) {
      SCOPED_TRACE(fmt::format("speckle --seed {} --set width={}", seed, size));
      const Settings speckle{{"width", size}, {"height", size}, {"robot", 0.19}, {"passage", 1.05}, {"cell", 0.4}};
      const Problem problem(generate("speckle", speckle, seed), robot);
      const Path path = plan_stc(problem);
      // It ends where the first round began: on the transit there, or where that ends.
      const Polyline& arrival = path.legs.front().points;
      const auto at_end = [&](const Point& p) { return distance(p, path.legs.back().points.back()) < 1e-9; };
      EXPECT_TRUE(std::any_of(arrival.begin(), arrival.end(), at_end));
      const double side = 0.4 / std::sqrt(2.0);
      const double cells = path.length(true) / side;
      EXPECT_NEAR(cells, std::round(cells), 1e-6);
    }
}

TEST(Stc, TurnsWithTheMap) {
  // The same room, turned: with align = edges the path is as long as on the axes.
  const Region room = box_region({0, 0}, {7.3, 5.1});
  const double straight = plan_stc(Problem({"room", room, "test", ""}, Robot{}, Point(1, 1))).length(true);
  for (const double angle : {0.2, 0.6, 1.1}) {
    const Problem turned({"room", transformed(room, angle, {3, -8}), "test", ""}, Robot{},
                         Point(rotated({1, 1}, angle) + Point(3, -8)));
    EXPECT_NEAR(plan_stc(turned, {{"align", std::string("edges")}}).length(true), straight, 1e-6) << angle;
  }
}

TEST(Stc, NoFittingCellIsOneSentence) {
  const Problem problem({"closet", box_region({0, 0}, {0.6, 0.6}), "test", ""}, Robot{});
  EXPECT_THAT([&] { plan_stc(problem); }, testing::ThrowsMessage<Infeasible>(testing::HasSubstr("smaller cell_size")));
}

}  // namespace
}  // namespace oxturn
