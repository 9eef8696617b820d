// Planners that drive from cell to cell, on thousands of small drawn maps: every reachable cell is visited, paths are
// valid, explorers keep their bounds. The oracle is the drawing: its letters, a flood fill, counts of cells, edges and
// holes.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pthread.h>

#include <cmath>
#include <map>
#include <set>

#include "algorithms/coverage_planner.hpp"
#include "maps/generators.hpp"
#include "metrics/score.hpp"
#include "tests/support/drawn.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/planners.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using Location = std::pair<int, int>;  // column, row
const std::vector<Location> kFour{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};

// A robot much smaller than a letter, with a tool as wide as its diagonal: the letters are exactly the free cells.
DrawnMap small_robot() {
  Robot robot;
  robot.radius = 0.2;
  robot.tool_width = 1.42;
  return {.robot = robot};
}

// The lattice of wavefront is placed by the walls, which are 0.2 m off; those of the others by the start.
Settings on_letters(const std::string& name) {
  if (name != "wavefront") return {{"cell_size", 1.0}};
  return {{"cell_size", 1.0}, {"shift_x", 0.3}, {"shift_y", 0.3}};
}

struct Drawn {
  std::vector<std::string> rows;
  bool free(const Location& p) const {
    const int n = static_cast<int>(rows.size());
    return p.second >= 0 && p.second < n && p.first >= 0 && p.first < static_cast<int>(rows[0].size()) &&
           rows[static_cast<std::size_t>(n - 1 - p.second)][static_cast<std::size_t>(p.first)] != '#';
  }
  void set(const Location& p, char letter) {
    rows[rows.size() - 1 - static_cast<std::size_t>(p.second)][static_cast<std::size_t>(p.first)] = letter;
  }
  Location start() const {
    const Point at = *drawn_point(rows, 'S');
    return {static_cast<int>(at.x()), static_cast<int>(at.y())};
  }
  std::set<Location> reachable() const {
    std::set<Location> seen{start()};
    std::vector<Location> queue{start()};
    for (std::size_t k = 0; k < queue.size(); ++k)
      for (const Location& d : kFour) {
        const Location to{queue[k].first + d.first, queue[k].second + d.second};
        if (free(to) && seen.insert(to).second) queue.push_back(to);
      }
    return seen;
  }
  std::string text() const {
    std::string all;
    for (const std::string& row : rows) all += "\n" + row;
    return all;
  }
};

Drawn random_drawing(std::uint64_t seed, int most) {
  Rng rng(seed);
  const int columns = rng.between(2, most), rows = rng.between(2, most);
  const double walls = rng.between(0.0, 0.5);
  Drawn drawn{
      std::vector<std::string>(static_cast<std::size_t>(rows), std::string(static_cast<std::size_t>(columns), '.'))};
  for (std::string& row : drawn.rows)
    for (char& letter : row)
      if (rng.chance(walls)) letter = '#';
  drawn.set({rng.between(0, columns - 1), rng.between(0, rows - 1)}, 'S');
  return drawn;
}

// The cells whose centre a leg with the tool on passes.
std::set<Location> cells_under(const Path& path, const Location& start) {
  std::set<Location> cells{start};
  for (const Leg& leg : path.legs) {
    if (!leg.tool) continue;
    for (std::size_t k = 0; k + 1 < leg.points.size(); ++k) {
      const Point a = leg.points[k], d = leg.points[k + 1] - a;
      const int n = std::max(1, static_cast<int>(std::lround(d.cwiseAbs().maxCoeff())));
      for (int s = 0; s <= n; ++s) {
        const Point at = a + d * (double(s) / n);
        const Location cell{static_cast<int>(std::floor(at.x())), static_cast<int>(std::floor(at.y()))};
        if (distance(at, {cell.first + 0.5, cell.second + 0.5}) < 1e-3) cells.insert(cell);
      }
    }
  }
  return cells;
}

struct Variant {
  std::string name;
  Settings settings = {};
};
const std::vector<Variant>& complete_planners() {
  static const std::vector<Variant> all{{"bsa"},
                                        {"bsa", {{"backtrack", std::string("latest")}}},
                                        {"bsa", {{"partial", true}}},
                                        {"linked-spiral"},
                                        {"linked-spiral", {{"partial", true}}},
                                        {"ba-star"},
                                        {"ba-star", {{"smooth", false}}},
                                        {"smart-dfs"},
                                        {"cell-explore"},
                                        {"wavefront"},
                                        {"wavefront", {{"goal", std::string("farthest")}}},
                                        {"wavefront", {{"transform", std::string("path")}}}};
  return all;
}

TEST(CellPlanners, VisitEveryReachableCell) {
  for (const auto seed : seeds(1200)) {
    const Drawn drawn_map = random_drawing(seed, 12);
    const std::set<Location> reachable = drawn_map.reachable();
    if (reachable.size() < 2) continue;
    SCOPED_TRACE(fmt::format("seed {}{}", seed, drawn_map.text()));
    const Problem problem = drawn(drawn_map.rows, small_robot());
    for (const Variant& variant : complete_planners()) {
      Settings settings = on_letters(variant.name);
      settings.insert(variant.settings.begin(), variant.settings.end());
      const RecordedPlan result = plan_recorded(variant.name, problem, settings);
      ASSERT_EQ(cells_under(result.path, drawn_map.start()), reachable) << variant.name;
      ASSERT_EQ(result.figures.at("cells"), static_cast<double>(reachable.size())) << variant.name;
      if (seed % 8 == 0) { ASSERT_EQ(find_flaw(problem, result.path), "") << variant.name; }
    }
  }
}

// --- bounds of the explorers ---

// Walls that are connected to the world outside by eight neighbours; the rest are holes.
std::set<Location> outside(const Drawn& map, const std::set<Location>& cells) {
  const int columns = static_cast<int>(map.rows[0].size()), rows = static_cast<int>(map.rows.size());
  std::set<Location> seen{{-1, -1}};
  std::vector<Location> queue{{-1, -1}};
  for (std::size_t k = 0; k < queue.size(); ++k)
    for (int di = -1; di <= 1; ++di)
      for (int dj = -1; dj <= 1; ++dj) {
        const Location to{queue[k].first + di, queue[k].second + dj};
        if (to.first < -1 || to.second < -1 || to.first > columns || to.second > rows || cells.count(to)) continue;
        if (seen.insert(to).second) queue.push_back(to);
      }
  return seen;
}

struct Counts {
  int cells = 0, edges = 0, holes = 0, reflex = 0;
};
Counts count(const Drawn& map, const std::set<Location>& cells) {
  Counts counts;
  std::set<Location> outer = outside(map, cells), known = outer;
  for (const Location& c : cells) {
    ++counts.cells;
    for (const Location& d : kFour) counts.edges += !cells.count({c.first + d.first, c.second + d.second});
  }
  for (int i = 0; i < static_cast<int>(map.rows[0].size()); ++i)
    for (int j = 0; j < static_cast<int>(map.rows.size()); ++j) {
      if (cells.count({i, j}) || !known.insert({i, j}).second) continue;
      ++counts.holes;
      std::vector<Location> queue{{i, j}};
      for (std::size_t k = 0; k < queue.size(); ++k)
        for (int di = -1; di <= 1; ++di)
          for (int dj = -1; dj <= 1; ++dj) {
            const Location to{queue[k].first + di, queue[k].second + dj};
            if (!cells.count(to) && known.insert(to).second) queue.push_back(to);
          }
    }
  // Reflex vertices of the outer wall: one wall cell among the four around a lattice point, or two diagonal ones.
  for (const Location& w : outer)
    for (const int di : {-1, 1})
      for (const int dj : {-1, 1})
        counts.reflex += cells.count({w.first + di, w.second}) && cells.count({w.first, w.second + dj});
  return counts;
}

// A random drawing with the start at a reachable cell of its outer wall, on demand without holes.
std::optional<Drawn> explorers_world(std::uint64_t seed, bool holes) {
  Drawn map = random_drawing(seed, 11);
  std::set<Location> cells = map.reachable();
  std::set<Location> outer = outside(map, cells);
  const int columns = static_cast<int>(map.rows[0].size()), rows = static_cast<int>(map.rows.size());
  map.set(map.start(), '.');
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      if (!holes && !outer.count({i, j})) cells.insert({i, j});
      map.set({i, j}, cells.count({i, j}) ? '.' : '#');
    }
  std::vector<Location> boundary;
  for (const Location& c : cells)
    if (std::any_of(kFour.begin(), kFour.end(), [&](const Location& d) {
          return outer.count({c.first + d.first, c.second + d.second});
        }))
      boundary.push_back(c);
  if (cells.size() < 2) return std::nullopt;
  Rng rng(seed);
  map.set(boundary[rng.below(boundary.size())], 'S');
  return map;
}

int moves(const RecordedPlan& result, const Drawn& map) {
  EXPECT_EQ(cells_under(result.path, map.start()), map.reachable());
  const Point end = result.path.legs.back().points.back();
  EXPECT_LT(distance(end, *drawn_point(map.rows, 'S')), 1e-9) << "does not return to the start";
  return static_cast<int>(std::lround(result.path.length()));
}

TEST(SmartDfs, KeepsItsBoundWithoutHoles) {
  for (const auto seed : seeds(3000)) {
    const auto map = explorers_world(seed, false);
    if (!map) continue;
    const Counts n = count(*map, map->reachable());
    ASSERT_EQ(n.holes, 0);
    const Problem problem = drawn(map->rows, small_robot());
    ASSERT_LE(2 * moves(plan_recorded("smart-dfs", problem, {{"cell_size", 1.0}}), *map), 2 * n.cells + n.edges - 6)
        << "seed " << seed << map->text();
  }
}

TEST(CellExplore, KeepsItsBoundWithHoles) {
  int with_holes = 0;
  for (const auto seed : seeds(3000)) {
    const auto map = explorers_world(seed, true);
    if (!map) continue;
    const Counts n = count(*map, map->reachable());
    const Problem problem = drawn(map->rows, small_robot());
    ASSERT_LE(2 * moves(plan_recorded("cell-explore", problem, {{"cell_size", 1.0}}), *map),
              2 * n.cells + n.edges + 6 * n.holes + 2 * n.reflex - 4)
        << "seed " << seed << map->text();
    with_holes += n.holes > 0;
  }
  EXPECT_GT(with_holes, 300);
}

// --- single rules ---

TEST(Wavefront, StopsWhereItIsClosedInOnDemand) {
  const Drawn map{{"......", "......", "..S...", "......"}};
  const Problem problem = drawn(map.rows, small_robot());
  Settings settings = on_letters("wavefront");
  settings["stop"] = std::string("closed");
  EXPECT_LT(cells_under(plan_recorded("wavefront", problem, settings).path, map.start()).size(), 24u);
}

TEST(Wavefront, GoesOnToComponentsThatNoStepLeadsTo) {
  // The cells of the right room are half a cell off: no lattice edge leads through the slanted door.
  Polygon rooms;
  rooms.outer = {{0, 0},  {4, 0}, {4, 1.2}, {6, 1.7}, {6, 0}, {10, 0},
                 {10, 4}, {6, 4}, {6, 2.3}, {4, 1.8}, {4, 4}, {0, 4}};
  const Problem problem({"rooms", {{rooms}}, "test", ""}, Robot{}, Point(2, 2));
  const auto covered = [&](const char* components) {
    return score(
               problem,
               plan_recorded("wavefront", problem, {{"cell_size", 0.6}, {"components", std::string(components)}}).path)
        .value("coverage")
        .value();
  };
  EXPECT_GT(covered("all"), 1.5 * covered("start"));
  // On a detour where the path passes the door, not at the end.
  const Path path = plan_recorded("wavefront", problem, {{"cell_size", 0.6}}).path;
  EXPECT_LT(path.legs.back().points.back().x(), 4);
}

/// A row of rooms with doors through which no step of the lattice leads: each is a detour within the one before.
Problem rooms_in_a_row(int rooms) {
  Polygon row;
  for (int k = 0; k < rooms; ++k) {
    const double x = 2 * k;
    if (k > 0) row.outer.insert(row.outer.end(), {{x - 0.2, 0.29}, {x, 0.29}});
    row.outer.insert(row.outer.end(), {{x, 0}, {x + 1.8, 0}});
  }
  for (int k = rooms; k-- > 0;) {
    const double x = 2 * k;
    row.outer.insert(row.outer.end(), {{x + 1.8, 1.4}, {x, 1.4}});
    if (k > 0) row.outer.insert(row.outer.end(), {{x, 0.71}, {x - 0.2, 0.71}});
  }
  return Problem({"row", {{row}}, "test", ""}, Robot{}, Point(0.5, 0.5));
}

TEST(Wavefront, NestedComponentsNeedNoDeepStack) {
  constexpr std::size_t kStack = std::size_t{1} << 20;  // bytes
  struct Run {
    Problem problem = rooms_in_a_row(6000);
    Path path;
  } run;
  pthread_attr_t attributes;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, kStack), 0);
  const auto work = [](void* p) -> void* {
    Run& r = *static_cast<Run*>(p);
    r.path = plan_recorded("wavefront", r.problem, {{"cell_size", 0.6}}).path;
    return nullptr;
  };
  pthread_t thread;
  ASSERT_EQ(pthread_create(&thread, &attributes, work, &run), 0);
  ASSERT_EQ(pthread_join(thread, nullptr), 0);
  EXPECT_EQ(find_flaw(run.problem, run.path), "");
  double right = 0;
  for (const Leg& leg : run.path.legs)
    for (const Point& p : leg.points) right = std::max(right, p.x());
  EXPECT_GT(right, 11'999);
  EXPECT_LT(run.path.legs.back().points.back().x(), 2) << "the detours come back";
}

TEST(Bsa, StepsPerCellAmongScatteredObstacles) {
  Rng rng(3);
  Drawn map{std::vector<std::string>(60, std::string(60, '.'))};
  for (std::string& row : map.rows)
    for (char& letter : row)
      if (rng.chance(0.1)) letter = '#';
  map.set({30, 30}, 'S');
  const Problem problem = drawn(map.rows, small_robot());
  const double cells = static_cast<double>(map.reachable().size());
  EXPECT_LE(plan_recorded("bsa", problem, {{"cell_size", 1.0}}).path.length() / cells, 1.28);
}

TEST(CellPlanners, FollowingWallsCoversWhatCellsLeave) {
  for (const char* generator : {"polygon", "cave"}) {
    const Problem problem(generate(generator, {}, 5), Robot{});
    for (const char* name : {"bsa", "linked-spiral"}) {
      SCOPED_TRACE(fmt::format("{} on {}", name, generator));
      const Path without = plan_recorded(name, problem).path,
                 with = plan_recorded(name, problem, {{"partial", true}}).path;
      const Score plain = score(problem, without), walls = score(problem, with);
      EXPECT_EQ(plain.flaw, "");
      EXPECT_EQ(walls.flaw, "");
      EXPECT_GT(walls.value("coverage").value(), 0.99);
      EXPECT_GT(walls.value("coverage").value(), plain.value("coverage").value());
    }
  }
}

// In long stretches: there was a tooth there and back for each cell where a wall had been followed on one side.
TEST(CellPlanners, WallsAreFollowedWithoutTeeth) {
  double linked = 0, bsa = 0;
  for (const char* generator : {"rooms", "polygon", "cave"}) {
    const Problem problem(generate(generator, {{"width", 12.0}, {"height", 10.0}}, 1), Robot{});
    const auto turns = [&](const char* name) {
      const Score result = score(problem, plan_recorded(name, problem, {{"partial", true}}).path);
      EXPECT_EQ(result.flaw, "");
      EXPECT_GT(result.value("coverage").value(), 0.99);
      return result.value("turns").value();
    };
    linked += turns("linked-spiral");
    bsa += turns("bsa");  // which begins most walls at an end
  }
  EXPECT_LT(linked, bsa);
}

// Borders of cells leave no vertices on straight walls.
TEST(CellPlanners, AWallIsFollowedStraight) {
  const Problem problem({"room", box_region({0, 0}, {7.3, 5.1}), "test", ""}, Robot{}, Point(1, 1));
  for (const char* name : {"bsa", "linked-spiral"})
    for (const Leg& leg : plan_recorded(name, problem, {{"partial", true}}).path.legs)
      for (std::size_t k = 2; k < leg.points.size(); ++k) {
        const Point a = leg.points[k - 1] - leg.points[k - 2], b = leg.points[k] - leg.points[k - 1];
        EXPECT_GT(std::abs(a.x() * b.y() - a.y() * b.x()) + (a.dot(b) < 0 ? 1 : 0), 1e-9) << name;
      }
}

// Vertices closer than a hundredth of the radius are of no use to a robot.
TEST(CellPlanners, NoTinySegments) {
  for (const char* generator : {"rooms", "clutter", "cave", "field"}) {
    const Problem problem(generate(generator, {{"width", 12.0}, {"height", 10.0}}, 3), Robot{});
    for (const PlannerInfo& planner : built_in()) {
      if (planner.family != "grid" || planner.name == "hyun") continue;  // hyun drives from wall to wall, not by cells
      SCOPED_TRACE(fmt::format("{} on {}", planner.name, generator));
      double shortest = 1;
      for (const Leg& leg : plan_recorded(planner.name, problem).path.legs)
        for (std::size_t k = 1; k < leg.points.size(); ++k)
          shortest = std::min(shortest, distance(leg.points[k - 1], leg.points[k]));
      EXPECT_GT(shortest, problem.robot().radius / 100);
    }
  }
}

TEST(CellPlanners, AreDeterministicAndTurnWithTheWalls) {
  const Region room = box_region({0, 0}, {7.3, 5.1});
  for (const char* name : {"bsa", "linked-spiral", "ba-star", "smart-dfs", "cell-explore"}) {
    const Problem straight({"room", room, "test", ""}, Robot{}, Point(1, 1));
    const Path once = plan_recorded(name, straight).path;
    const Path again = plan_recorded(name, straight).path;
    ASSERT_EQ(once.legs.size(), again.legs.size());
    for (std::size_t k = 0; k < once.legs.size(); ++k) ASSERT_EQ(once.legs[k].points, again.legs[k].points);
    const Problem turned({"room", transformed(room, 0.6, {3, -8}), "test", ""}, Robot{},
                         Point(rotated({1, 1}, 0.6) + Point(3, -8)));
    EXPECT_NEAR(plan_recorded(name, turned, {{"align", std::string("edges")}}).path.length(), once.length(), 1e-6)
        << name;
  }
}

TEST(CellPlanners, AnEnclosedStartIsOneSentence) {
  const Problem problem = drawn({"S"}, small_robot());
  for (const char* name : {"bsa", "linked-spiral", "ba-star", "smart-dfs", "cell-explore"})
    EXPECT_THAT(
        [&] {
          plan_recorded(name, problem, {{"cell_size", 1.0}});
        },
        testing::ThrowsMessage<Infeasible>(testing::HasSubstr("smaller cell_size")))
        << name;
}

TEST(CellPlanners, ByLidarTheSameCellsAsOnTheMap) {
  const Drawn map{{"......", "..##..", "S..#..", "...#.."}};
  Robot robot;
  robot.lidar = Lidar{6, 360, 0};
  const Problem problem = drawn(map.rows, {.cell = 0.5, .robot = robot});
  for (const char* name : {"bsa", "linked-spiral", "ba-star", "smart-dfs", "cell-explore"}) {
    SCOPED_TRACE(name);
    const RecordedPlan seen = plan_recorded(name, problem, {{"sensing", std::string("lidar")}, {"cell_size", 0.5}});
    EXPECT_EQ(find_flaw(problem, seen.path), "");
    EXPECT_EQ(seen.figures.at("cells"), static_cast<double>(map.reachable().size()));
  }
}

TEST(CellPlanners, LidarNeedsALidarAndNoMap) {
  const Problem problem(generate("rectangle", {}, 1), Robot{});
  const std::string lidar = "lidar";
  EXPECT_THROW(plan_recorded("bsa", problem, {{"sensing", lidar}}), Unsupported);
  EXPECT_THAT(
      [&] {
        plan_recorded("bsa", problem, {{"sensing", lidar}, {"align", std::string("edges")}});
      },
      testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("align = axes")));
  EXPECT_THAT(
      [&] {
        plan_recorded("bsa", problem, {{"sensing", lidar}, {"partial", true}});
      },
      testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("partial = false")));
}

}  // namespace
}  // namespace oxturn
