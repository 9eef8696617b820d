// stc-spiral, stc-scan and partial cells, on drawings whose letters are the sub-cells. The oracle is a flood fill of
// the letters.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "algorithms/coverage_planner.hpp"
#include "base/random.hpp"
#include "maps/generators.hpp"
#include "metrics/score.hpp"
#include "tests/support/drawn.hpp"
#include "tests/support/planners.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using Location = std::pair<int, int>;
using Letters = std::vector<std::string>;

constexpr Location kSteps[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};

bool free_at(const Letters& rows, const Location& p) {
  const int n = static_cast<int>(rows.size());
  if (p.first < 0 || p.second < 0 || p.second >= n || p.first >= static_cast<int>(rows[0].size())) return false;
  return rows[static_cast<std::size_t>(n - 1 - p.second)][static_cast<std::size_t>(p.first)] != '#';
}

// Letters are sub-cells of 1 m. The robot is a little narrower, so it can drive between free letters that share a side.
Problem on_letters(const Letters& rows) {
  Robot robot;
  robot.radius = 0.45;
  robot.tool_width = std::sqrt(2.0);
  return drawn(rows, {.robot = robot});
}

Letters random_drawing(Rng& rng) {
  const std::size_t columns = 3 + rng.below(9), rows = 3 + rng.below(9);
  const double blocked = 0.4 * rng.unit();
  const bool blocks = rng.chance(0.4);  // of two by two letters, so that many coarse cells are entirely free
  const std::size_t shift = rng.below(2);
  Letters drawing(rows, std::string(columns, '.'));
  std::map<Location, bool> wall;
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const Location key = blocks ? Location((i + shift) / 2, (j + shift) / 2) : Location(i, j);
      if (!wall.count(key)) wall[key] = rng.chance(blocked);
      if (wall[key]) drawing[j][i] = '#';
    }
  drawing[rng.below(rows)][rng.below(columns)] = 'S';
  return drawing;
}

Location start_of(const Letters& rows) {
  const Point p = *drawn_point(rows, 'S');
  return {static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y()))};
}

std::set<Location> flood(const Location& from, const std::function<bool(const Location&)>& free) {
  std::set<Location> seen;
  if (free(from)) seen.insert(from);
  std::vector<Location> queue(seen.begin(), seen.end());
  for (std::size_t k = 0; k < queue.size(); ++k)
    for (const Location& step : kSteps)
      if (const Location next{queue[k].first + step.first, queue[k].second + step.second};
          free(next) && seen.insert(next).second)
        queue.push_back(next);
  return seen;
}

// How often the legs with the tool on enter each letter. The first point does not count.
std::map<Location, int> visits(const Path& path, double& length) {
  std::map<Location, int> all;
  length = 0;
  for (const Leg& leg : path.legs) {
    if (!leg.tool) continue;
    for (std::size_t k = 1; k < leg.points.size(); ++k) {
      const Point d = leg.points[k] - leg.points[k - 1];
      const int steps = static_cast<int>(std::lround(d.norm()));
      EXPECT_NEAR(d.norm(), steps, 1e-2);
      for (int s = 1; s <= steps; ++s) {
        const Point at = leg.points[k - 1] + d * (double(s) / steps);
        ++all[{static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))}];
      }
      length += steps;
    }
  }
  return all;
}

std::set<Location> letters_of(const std::map<Location, int>& visits) {
  std::set<Location> all;
  for (const auto& visit : visits) all.insert(visit.first);
  return all;
}

std::size_t beside_a_wall(const Letters& rows, const std::set<Location>& cells) {
  std::size_t m = 0;
  for (const Location& c : cells) {
    bool touches = false;
    for (int di = -1; di <= 1; ++di)
      for (int dj = -1; dj <= 1; ++dj) touches = touches || !free_at(rows, {c.first + di, c.second + dj});
    m += touches;
  }
  return m;
}

Path plan(const char* name, const Problem& problem, const Settings& settings = {}) {
  Context context(1);
  return built_in_planner(name, settings)->plan(problem, context);
}

// The sub-cells of the entirely free coarse cells connected to the start's; empty if that one is not free. The start is
// the lower left, lower right, upper left or upper right sub-cell of its coarse cell: the first choice that is entirely
// free.
std::set<Location> whole_cells(const Letters& rows) {
  const Location s = start_of(rows);
  for (const Location& choice : {Location{0, 0}, Location{-1, 0}, Location{0, -1}, Location{-1, -1}}) {
    const auto whole = [&](const Location& coarse) {
      const Location low{s.first + choice.first + 2 * coarse.first, s.second + choice.second + 2 * coarse.second};
      return free_at(rows, low) && free_at(rows, {low.first + 1, low.second}) &&
             free_at(rows, {low.first, low.second + 1}) && free_at(rows, {low.first + 1, low.second + 1});
    };
    if (!whole({0, 0})) continue;
    std::set<Location> cells;
    for (const Location& coarse : flood({0, 0}, whole))
      for (int k = 0; k < 4; ++k)
        cells.insert(
            {s.first + choice.first + 2 * coarse.first + k % 2, s.second + choice.second + 2 * coarse.second + k / 2});
    return cells;
  }
  return {};
}

TEST(StcOnline, DrivesEachSubCellOfWholeCellsExactlyOnce) {
  int planned = 0;
  for (const auto seed : seeds(3000)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Letters rows = random_drawing(rng);
    const std::set<Location> expected = whole_cells(rows);
    if (expected.empty()) continue;
    const Problem problem = on_letters(rows);
    ++planned;
    for (const char* name : {"stc-spiral", "stc-scan"}) {
      SCOPED_TRACE(name);
      const Path path = plan(name, problem);
      double length = 0;
      const auto entered = visits(path, length);
      EXPECT_EQ(letters_of(entered), expected);
      for (const auto& [letter, times] : entered) EXPECT_EQ(times, 1) << letter.first << ", " << letter.second;
      EXPECT_EQ(length, static_cast<double>(expected.size()));
      EXPECT_LT(distance(path.legs.back().points.back(), problem.start()), 1e-9) << "not closed";
      EXPECT_EQ(find_flaw(problem, path), "");
    }
  }
  EXPECT_GT(planned, 1000);
}

// Offline, all components: the lattice begins at the lower left of what the robot can reach.
TEST(StcOffline, DrivesEachSubCellOfEveryComponentExactlyOnce) {
  int with_many_components = 0;
  for (const auto seed : seeds(3000)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Letters rows = random_drawing(rng);
    const std::set<Location> reach = flood(start_of(rows), [&](const Location& p) { return free_at(rows, p); });
    Location low = *reach.begin();
    for (const Location& p : reach) low = {std::min(low.first, p.first), std::min(low.second, p.second)};
    std::set<Location> corners, expected;
    for (const Location& p : reach) {
      if ((p.first - low.first) % 2 != 0 || (p.second - low.second) % 2 != 0) continue;
      std::vector<Location> quarters;
      for (int k = 0; k < 4; ++k) quarters.emplace_back(p.first + k % 2, p.second + k / 2);
      if (!std::all_of(quarters.begin(), quarters.end(), [&](const Location& q) { return reach.count(q) > 0; }))
        continue;
      corners.insert(p);
      expected.insert(quarters.begin(), quarters.end());
    }
    if (expected.empty()) continue;
    const std::set<Location> first = flood(*corners.begin(), [&](const Location& p) { return expected.count(p) > 0; });
    with_many_components += first.size() < expected.size();
    const Problem problem = on_letters(rows);
    for (const char* tree : {"bfs", "dfs", "minimum-turn", "random", "weighted"}) {
      SCOPED_TRACE(tree);
      const Path path = plan("stc", problem, {{"tree", std::string(tree)}});
      double length = 0;
      const auto entered = visits(path, length);
      EXPECT_EQ(letters_of(entered), expected);
      for (const auto& [letter, times] : entered) EXPECT_EQ(times, 1) << letter.first << ", " << letter.second;
      EXPECT_EQ(length, static_cast<double>(expected.size()));
      EXPECT_EQ(find_flaw(problem, path), "");
      // Closed: it ends where it began, which is on the path from the start.
      const Polyline& begin = path.legs.front().points;
      const Point end = path.legs.back().points.back();
      EXPECT_TRUE(std::any_of(begin.begin(), begin.end(), [&](const Point& p) { return distance(p, end) < 1e-9; }));
    }
  }
  EXPECT_GT(with_many_components, 500);
}

TEST(StcOnline, PartialVisitsAllReachableSubCellsWithinTheBound) {
  for (const auto seed : seeds(3000)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Letters rows = random_drawing(rng);
    const std::set<Location> expected = flood(start_of(rows), [&](const Location& p) { return free_at(rows, p); });
    if (expected.size() < 2) continue;
    const Problem problem = on_letters(rows);
    const double bound = static_cast<double>(expected.size() + beside_a_wall(rows, expected));
    for (const char* name : {"stc-spiral", "stc-scan"}) {
      SCOPED_TRACE(name);
      const Path path = plan(name, problem, {{"partial", true}});
      double length = 0;
      EXPECT_EQ(letters_of(visits(path, length)), expected);
      EXPECT_LE(length, bound);
      EXPECT_LT(distance(path.legs.back().points.back(), problem.start()), 1e-9) << "not closed";
      EXPECT_EQ(find_flaw(problem, path), "");
    }
    for (const char* tree : {"bfs", "dfs", "minimum-turn", "random", "weighted"}) {
      SCOPED_TRACE(tree);
      const Path path = plan("stc", problem, {{"partial", true}, {"cell_size", 1.0}, {"tree", std::string(tree)}});
      double length = 0;
      auto seen = letters_of(visits(path, length));
      EXPECT_EQ(seen, expected);
      EXPECT_LE(length, bound);
      EXPECT_EQ(find_flaw(problem, path), "");
    }
  }
}

TEST(StcOnline, PartialLengthsByHand) {
  const auto length = [](const Letters& rows) {
    return plan("stc-spiral", on_letters(rows), {{"partial", true}}).length();
  };
  EXPECT_NEAR(length({"S......"}), 12, 1e-9);                       // there and back
  EXPECT_NEAR(length({"S.", ".#"}), 4, 1e-9);                       // three sub-cells of one coarse cell
  EXPECT_NEAR(length({"....", "....", "....", "S..."}), 16, 1e-9);  // all cells are whole: each sub-cell once
  // A ring one letter wide around a pillar of four by four letters.
  EXPECT_LE(length({"......", ".####.", ".####.", ".####.", ".####.", "S....."}), 40);
}

TEST(StcOnline, ScanDrivesLanes) {
  const Problem room({"room", box_region({0, 0}, {12, 9}), "test", ""}, Robot{}, Point(6, 4));
  const auto turns = [&](const char* name) { return score(room, plan(name, room)).value("turns").value(); };
  // 42 x 32 sub-cells: lanes as long as the room is high, and the turns between them.
  EXPECT_LT(turns("stc-scan"), 120);
  EXPECT_LT(plan("stc-scan", room).length(), plan("stc-spiral", room).length() + 1e-6);
  EXPECT_EQ(find_flaw(room, plan("stc-scan", room)), "");
}

TEST(StcOnline, ByLidarPathsAreValidAsWell) {
  Robot robot;
  robot.lidar = Lidar{6, 360};
  for (const char* name : {"stc-spiral", "stc-scan"})
    for (const bool partial : {false, true}) {
      SCOPED_TRACE(name);
      const Problem problem({"room", box_region({0, 0}, {4, 3}), "test", ""}, robot, Point(1.5, 1.5));
      const Path path = plan(name, problem, {{"partial", partial}, {"sensing", std::string("lidar")}});
      const Score result = score(problem, path);
      EXPECT_EQ(result.flaw, "");
      EXPECT_GT(result.value("coverage_lower").value(), partial ? 0.75 : 0.6);
    }
}

TEST(StcOnline, NoFittingCellIsOneSentence) {
  EXPECT_THAT([] { plan("stc-spiral", on_letters({"S...."})); },
              testing::ThrowsMessage<Infeasible>(testing::HasSubstr("partial = true may help")));
}

}  // namespace
}  // namespace oxturn
