#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lattice/grid_graph.hpp"
#include "algorithms/lattice/lattice_paths.hpp"
#include "algorithms/grid/rectangle_world.hpp"
#include "maps/generators.hpp"
#include "metrics/score.hpp"
#include "tests/support/seeds.hpp"
#include "tests/support/planners.hpp"
#include "tests/support/maps.hpp"

namespace oxturn {
namespace {

// '.' is free; the last line is row 0.
BitGrid drawn_grid(const std::vector<std::string>& lines) {
  BitGrid grid({0, 0}, 1, static_cast<int>(lines.front().size()), static_cast<int>(lines.size()));
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i)
      grid.set(i, j, lines[static_cast<std::size_t>(grid.rows - 1 - j)][static_cast<std::size_t>(i)] == '.');
  return grid;
}

BitGrid noise(std::uint64_t seed, double walls) {
  Rng rng(seed);
  BitGrid grid({0, 0}, 1, rng.between(1, 30), rng.between(1, 30));
  for (auto& bit : grid.bits) bit = rng.chance(1 - walls);
  return grid;
}

// The source's words, one cell at a time: find the first dirty cell, measure upwards, go right. `done` is wall.
std::vector<CellRectangle> literal_partition(BitGrid dirty, bool by_rows) {
  std::vector<CellRectangle> found;
  for (;;) {
    int i0 = -1, j0 = -1;
    for (int k = 0; k < dirty.columns * dirty.rows && i0 < 0; ++k) {
      const int i = by_rows ? k % dirty.columns : k / dirty.rows, j = by_rows ? k / dirty.columns : k % dirty.rows;
      if (dirty.get(i, j)) {
        i0 = i;
        j0 = j;
      }
    }
    if (i0 < 0) return found;
    CellRectangle r{i0, j0, i0, j0};
    while (dirty.get(i0, r.top + 1)) ++r.top;
    const auto column_free = [&](int i) {
      for (int j = r.bottom; j <= r.top; ++j)
        if (!dirty.get(i, j)) return false;
      return true;
    };
    while (column_free(r.right + 1)) ++r.right;
    for (int j = r.bottom; j <= r.top; ++j)
      for (int i = r.left; i <= r.right; ++i) dirty.set(i, j, false);
    found.push_back(r);
  }
}

TEST(RectangleWorld, PartitionIsTheSourcesAndCoversEachCellOnce) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const BitGrid grid = noise(seed, 0.05 + 0.001 * double(seed));
    const bool by_rows = seed % 2 == 0;
    const auto rectangles = rectangles_of(grid, by_rows);
    EXPECT_EQ(rectangles, literal_partition(grid, by_rows)) << seed;
    std::size_t cells = 0;
    for (const CellRectangle& r : rectangles) cells += static_cast<std::size_t>(r.width() * r.height());
    EXPECT_EQ(cells, grid.count());
  }
}

// Decision 3 of the planner: partitioning anew after a rectangle is done changes nothing for the others.
TEST(RectangleWorld, TakingARectangleAwayLeavesTheOthers) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    BitGrid grid = noise(seed, 0.15);
    std::vector<CellRectangle> all = rectangles_of(grid, seed % 2 == 0);
    if (all.empty()) continue;
    const std::size_t k = Rng(seed).below(all.size());
    for (int j = all[k].bottom; j <= all[k].top; ++j)
      for (int i = all[k].left; i <= all[k].right; ++i) grid.set(i, j, false);
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_EQ(literal_partition(grid, seed % 2 == 0), all) << seed;
  }
}

TEST(RectangleWorld, ClosesGapsOfOneCellAndNoWiderOnes) {
  const BitGrid mended = without_gaps(drawn_grid({".......", ".##.##.", ".......", "##..###", "......."}), 1, 0);
  EXPECT_FALSE(mended.get(3, 3)) << "one cell between walls";
  EXPECT_TRUE(mended.get(2, 1)) << "two cells between walls";
  EXPECT_TRUE(mended.get(0, 2)) << "the border of the world is no wall";
}

TEST(RectangleWorld, FillsTheCornersOfSmallObstaclesOnly) {
  const BitGrid grid = drawn_grid({".........", ".#.......", ".##......", ".........", "....#####", "....#....",
                                   "....#....", "....#....", "....#...."});
  const BitGrid mended = without_gaps(grid, 0, 2);
  EXPECT_FALSE(mended.get(2, 7)) << "missing corner of the small one";
  EXPECT_TRUE(mended.get(5, 3)) << "inner corner of the large one";
  EXPECT_EQ(mended.count() + 1, grid.count());
}

Path plan_rectangles(const Problem& problem, const Settings& settings = {}) {
  Context context(1);
  return built_in_planner("rectangles", settings)->plan(problem, context);
}

TEST(Rectangles, AnEmptyRoomIsOneRectangleDrivenColumnByColumn) {
  const Problem problem({"room", box_region({0, 0}, {4, 3}), "test", ""}, Robot{}, Point(2, 1.5));
  const Path path = plan_rectangles(problem);
  int work = 0;
  for (const Leg& leg : path.legs) work += leg.tool;
  EXPECT_EQ(work, 1);
  // 19 columns of 2.6 m, from wall to wall, 0.2 apart.
  EXPECT_NEAR(path.length(true), 19 * 2.6 + 18 * 0.2, 0.001);
}

TEST(Rectangles, EverySegmentStaysInConfigurationSpace) {
  for (const char* generator : {"rectangle", "polygon", "clutter", "rooms", "cave", "maze"})
    for (std::uint64_t seed = 1; seed <= 6; ++seed)
      for (const char* choose : {"first", "nearest"}) {
        SCOPED_TRACE(fmt::format("{} --seed {} {}", generator, seed, choose));
        const Problem problem(generate(generator, {}, seed), Robot{});
        const EdgeIndex walls(problem.map().free);
        Path path;
        try {
          path = plan_rectangles(problem, {{"choose", std::string(choose)}});
        } catch (const Infeasible&) { continue; }
        EXPECT_LT(distance(path.legs.front().points.front(), problem.start()), 1e-12);
        for (const Leg& leg : path.legs)
          for (std::size_t k = 1; k < leg.points.size(); ++k) {
            const auto near = walls.nearest(leg.points[k - 1], leg.points[k], 0.2);
            ASSERT_TRUE(!near || near->distance >= 0.2 - problem.tolerance()) << near->distance;
          }
      }
}

// revisit_skipped: every lattice node in configuration space is driven over; found here with exact point location.
TEST(Rectangles, RevisitingLeavesNoReachableNode) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    SCOPED_TRACE(fmt::format("clutter --seed {}", seed));
    const Problem problem(generate("clutter", {}, seed), Robot{});
    const Path path = plan_rectangles(problem, {{"revisit_skipped", true}});
    const GridGraph graph = make_grid_graph(problem, {}, 0.2, 1, 2);
    std::set<std::pair<int, int>> driven;
    for (const Leg& leg : path.legs)
      if (leg.tool)
        for (std::size_t k = 1; k < leg.points.size(); ++k) {
          const int steps = 1 + static_cast<int>(distance(leg.points[k - 1], leg.points[k]) / 0.05);
          for (int s = 0; s <= steps; ++s) {
            const Point at = graph.coordinates(lerp(leg.points[k - 1], leg.points[k], double(s) / steps));
            driven.insert({static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))});
          }
        }
    for (int j = 0; j < graph.rows(); ++j)
      for (int i = 0; i < graph.columns(); ++i)
        if (graph.free(i, j)) { EXPECT_TRUE(driven.count({i, j})) << i << " " << j; }
  }
}

// Against a flood fill of its own.
TEST(LatticePaths, LeadWhereAFloodFillDoesAndAreHardlyLongerThanItsSteps) {
  Robot robot;
  robot.radius = 0.45;  // in cells of 1 m, all of the lattice is well inside or well outside
  robot.tool_width = 0.9;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    SCOPED_TRACE(seed);
    const Region free = trace(noise(seed, 0.05 + 0.001 * double(seed % 300)));
    if (free.polygons.empty()) continue;
    const Problem problem({"noise", {{free.polygons.front()}}, "test", ""}, robot);
    const GridGraph graph = make_grid_graph(problem, {}, 1, 1, 1);
    LatticePaths ways(graph, problem.walls());
    Rng rng(seed);
    std::vector<std::size_t> nodes;
    for (std::size_t c = 0; c < graph.size(); ++c)
      if (ways.part(c) >= 0) nodes.push_back(c);
    const auto i_of = [&](std::size_t c) { return static_cast<int>(c % static_cast<std::size_t>(graph.columns())); };
    const auto j_of = [&](std::size_t c) { return static_cast<int>(c / static_cast<std::size_t>(graph.columns())); };
    if (nodes.empty()) continue;
    const std::size_t from = nodes[rng.below(nodes.size())];
    std::vector<int> steps(graph.size(), -1);
    std::vector<std::size_t> queue{from};
    steps[from] = 0;
    for (std::size_t k = 0; k < queue.size(); ++k)
      for (const Direction d : kAllDirections) {
        const int i = i_of(queue[k]) + kColumnStep[d], j = j_of(queue[k]) + kRowStep[d];
        if (!graph.free(i, j) || steps[graph.at(i, j)] >= 0) continue;
        if (!problem.walls().contains(graph.centre(i_of(queue[k]), j_of(queue[k])), graph.centre(i, j))) continue;
        steps[graph.at(i, j)] = steps[queue[k]] + 1;
        queue.push_back(graph.at(i, j));
      }
    for (int k = 0; k < 5; ++k) {
      const std::size_t to = nodes[rng.below(nodes.size())];
      const Polyline way = ways.way(from, to);
      EXPECT_EQ(way.empty(), steps[to] < 0);
      const auto found = ways.nearest(from, [&](std::size_t c) { return c == to; });
      EXPECT_EQ(found.has_value(), steps[to] >= 0);
      if (way.empty()) continue;
      const Point a = graph.centre(i_of(from), j_of(from)), b = graph.centre(i_of(to), j_of(to));
      EXPECT_EQ(way.front(), a);
      EXPECT_EQ(way.back(), b);
      EXPECT_LE(length(way), steps[to] * graph.side() * 9 / 8 + 1e-9);
      EXPECT_LE(length(found->way), steps[to] * graph.side() + 1e-9);
      for (const Polyline& w : {way, found->way}) {
        EXPECT_GE(length(w), distance(a, b) - 1e-9);
        for (std::size_t m = 1; m < w.size(); ++m) ASSERT_TRUE(problem.walls().contains(w[m - 1], w[m]));
      }
    }
    const auto nearest = ways.nearest(from, [&](std::size_t c) { return c % 7 == 3; });
    int least = -1;
    for (const std::size_t c : queue)
      if (c % 7 == 3 && (least < 0 || steps[c] < least)) least = steps[c];
    EXPECT_EQ(nearest ? steps[nearest->node] : -1, least);
  }
}

double coverage_of(const Problem& problem, const Path& path) {
  const Score scored = score(problem, path);
  EXPECT_EQ(scored.flaw, "");
  return scored.value("coverage").value_or(0);
}

// The seed's 5.1: the literal choice shuttles between both sides; the nearest planned way does not.
TEST(Rectangles, InADividedCorridorTheNearestChoiceDoesNotShuttle) {
  for (const auto seed : seeds(5)) {
    SCOPED_TRACE(fmt::format("divided-corridor --seed {}", seed));
    const Problem problem(generate("divided-corridor", {}, seed), Robot{});
    const Settings literal{{"scan", std::string("rows")}, {"choose", std::string("first")}};
    const Settings mended{{"scan", std::string("rows")}, {"choose", std::string("nearest")}};
    const Path a = plan_rectangles(problem, literal), b = plan_rectangles(problem, mended);
    EXPECT_LT(b.length(false), 0.6 * a.length(false));
    EXPECT_LT(b.length(), 0.8 * a.length());
    EXPECT_GT(coverage_of(problem, b), coverage_of(problem, a) - 0.01);
  }
}

// The seed's 5.2: between staggered pillars straight lanes find few rectangles that can be driven. Lanes at 45 degrees do
// better: more is covered, and with less way for as much.
TEST(Rectangles, BetweenStaggeredPillarsDiagonalLanesDoBetter) {
  for (const auto seed : seeds(4)) {
    SCOPED_TRACE(fmt::format("pillars --seed {}", seed));
    const Problem problem(generate("pillars", {{"width", 9.0}, {"height", 9.0}, {"jitter", 0.3}}, seed), Robot{});
    const Settings mended{{"lanes", std::string("diagonal")}};
    const Path straight = plan_rectangles(problem), diagonal = plan_rectangles(problem, mended);
    const double before = coverage_of(problem, straight), after = coverage_of(problem, diagonal);
    EXPECT_GT(after, before + 0.1);
    EXPECT_LT(diagonal.length() / after, 0.9 * straight.length() / before);
    // Most of what is driven at work runs at 45 degrees.
    double at_work = 0, slanted = 0;
    for (const Leg& leg : diagonal.legs)
      for (std::size_t k = 1; leg.tool && k < leg.points.size(); ++k) {
        const Point d = leg.points[k] - leg.points[k - 1];
        at_work += d.norm();
        if (std::abs(std::abs(d.x()) - std::abs(d.y())) < 1e-6) slanted += d.norm();
      }
    EXPECT_GT(slanted, 0.7 * at_work);
  }
}

TEST(Rectangles, OnlineScansTheOuterWallThenCleansWhatOfflineDoes) {
  Robot robot;
  robot.lidar = Lidar{8, 360, 0};
  for (const auto& [generator, settings] : std::vector<std::pair<std::string, Settings>>{
           {"rectangle", {{"width", 4.0}, {"height", 3.0}}},
           {"rooms", {{"width", 5.0}, {"height", 4.0}, {"rooms", std::int64_t{2}}}},
           {"clutter", {{"width", 4.0}, {"height", 4.0}}}}) {
    SCOPED_TRACE(generator);
    const Problem problem(generate(generator, settings, 1), robot);
    std::map<std::string, double> reports;
    Context::Sinks sinks;
    sinks.record = [&](const std::string& figure, double value) { reports[figure] = value; };
    Context context(1, 1e9, sinks);
    const Path path =
        built_in_planner("rectangles", {{"sensing", std::string("lidar")}})->plan(problem, context);
    EXPECT_GT(coverage_of(problem, path), 0.75 * coverage_of(problem, plan_rectangles(problem)));
    EXPECT_GT(reports.at("explored_share"), 0.98);
    EXPECT_GE(reports.at("partitions"), 1);
  }
}

TEST(Rectangles, OnlineWithoutALidarIsASentence) {
  const Problem problem({"room", box_region({0, 0}, {4, 3}), "test", ""}, Robot{});
  EXPECT_THAT(
      [&] {
        plan_rectangles(problem, {{"sensing", std::string("lidar")}});
      },
      testing::ThrowsMessage<Unsupported>(testing::HasSubstr("has no lidar")));
}

TEST(Rectangles, NoRectangleIsASentence) {
  const Problem problem({"closet", box_region({0, 0}, {0.5, 0.5}), "test", ""}, Robot{});
  EXPECT_THAT(
      [&] {
        plan_rectangles(problem, {{"cell_size", 0.3}});
      },
      testing::ThrowsMessage<Infeasible>(testing::HasSubstr("2 x 2")));
}

}  // namespace
}  // namespace oxturn
