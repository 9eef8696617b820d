#include <algorithm>
#include <map>

#include "algorithms/polygon/fewest_lanes.hpp"
#include "coverage_oracle.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

constexpr int kSamples = 700;

BitGrid grid_of(const std::vector<std::string>& rows) {
  BitGrid grid({0, 0}, 1, static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i)
      grid.set(i, grid.rows - 1 - j, rows[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] != '#');
  return grid;
}

BitGrid filled(int columns, int rows) {
  BitGrid grid({0, 0}, 1, columns, rows);
  std::fill(grid.bits.begin(), grid.bits.end(), std::uint8_t{1});
  return grid;
}
void clear(BitGrid& grid, int i0, int i1, int j0, int j1) {
  for (int j = j0; j < j1; ++j)
    for (int i = i0; i < i1; ++i) grid.set(i, j, false);
}

/// Runs of cells that have an orientation each, counted by their first cells.
int runs_with(const BitGrid& grid, const std::vector<std::size_t>& cells, unsigned orientation) {
  std::map<std::size_t, bool> horizontal;
  for (std::size_t k = 0; k < cells.size(); ++k) horizontal[cells[k]] = (orientation >> k & 1) != 0;
  const auto is = [&](int i, int j, bool h) { return grid.get(i, j) && horizontal.at(grid.at(i, j)) == h; };
  int runs = 0;
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 0; i < grid.columns; ++i) {
      if (is(i, j, true) && !is(i - 1, j, true)) ++runs;
      if (is(i, j, false) && !is(i, j - 1, false)) ++runs;
    }
  return runs;
}

int fewest_by_trying(const BitGrid& grid) {
  std::vector<std::size_t> cells;
  for (std::size_t c = 0; c < grid.bits.size(); ++c)
    if (grid.bits[c] != 0) cells.push_back(c);
  int best = static_cast<int>(cells.size());
  for (unsigned o = 0; o < 1u << cells.size(); ++o) best = std::min(best, runs_with(grid, cells, o));
  return best;
}

/// Every cell lies in one run, and no two runs of one direction could be joined.
void expect_partition(const BitGrid& grid, const std::vector<CellRun>& runs) {
  std::vector<int> times(grid.bits.size(), 0);
  for (const CellRun& r : runs)
    for (int k = r.first; k <= r.last; ++k) ++times[r.horizontal ? grid.at(k, r.line) : grid.at(r.line, k)];
  for (std::size_t c = 0; c < times.size(); ++c) ASSERT_EQ(times[c], grid.bits[c]);
}

TEST(FewestRuns, AreAsFewAsTryingAllFinds) {
  Rng rng(5);
  for (int n = 0; n < 200; ++n) {
    BitGrid grid({0, 0}, 1, 1 + static_cast<int>(rng.below(4)), 1 + static_cast<int>(rng.below(3)));
    for (std::uint8_t& bit : grid.bits) bit = rng.below(4) > 0 ? 1 : 0;
    const int fewest = fewest_by_trying(grid);
    for (const bool compact : {false, true}) {
      const std::vector<CellRun> runs = fewest_runs(grid, compact);
      expect_partition(grid, runs);
      ASSERT_EQ(runs.size(), static_cast<std::size_t>(fewest)) << n;
    }
  }
}

// By hand: a plus takes its three long rows and the columns beside them, an L six, a square ring three on each side.
TEST(FewestRuns, OfKnownShapes) {
  BitGrid plus = filled(9, 9);
  for (const int i : {0, 6})
    for (const int j : {0, 6}) clear(plus, i, i + 3, j, j + 3);
  EXPECT_EQ(fewest_runs(plus, true).size(), 9u);
  BitGrid l = filled(10, 10);
  clear(l, 3, 10, 3, 10);
  EXPECT_EQ(fewest_runs(l, true).size(), 6u);
  BitGrid ring = filled(10, 10);
  clear(ring, 3, 7, 3, 7);
  EXPECT_EQ(fewest_runs(ring, true).size(), 12u);
  EXPECT_EQ(fewest_runs(filled(7, 4), false).size(), 4u);
  EXPECT_TRUE(fewest_runs(grid_of({"##", "##"}), true).empty());
}

TEST(FewestRuns, CompactRunsHaveFewerBorders) {
  for (const auto seed : seeds(10)) {
    Rng rng(seed);
    BitGrid grid({0, 0}, 1, 12, 9);
    for (std::uint8_t& bit : grid.bits) bit = rng.below(5) > 0 ? 1 : 0;
    const auto borders = [&](const std::vector<CellRun>& runs) {
      std::vector<int> orientation(grid.bits.size(), 0);
      for (const CellRun& r : runs)
        for (int k = r.first; k <= r.last; ++k)
          orientation[r.horizontal ? grid.at(k, r.line) : grid.at(r.line, k)] = r.horizontal ? 1 : 2;
      int count = 0;
      for (int j = 0; j < grid.rows; ++j)
        for (int i = 0; i < grid.columns; ++i)
          for (const auto& [di, dj] : {std::pair(1, 0), std::pair(0, 1)})
            if (grid.get(i, j) && grid.get(i + di, j + dj))
              count += orientation[grid.at(i, j)] != orientation[grid.at(i + di, j + dj)] ? 1 : 0;
      return count;
    };
    EXPECT_LE(borders(fewest_runs(grid, true)), borders(fewest_runs(grid, false))) << seed;
  }
}

TEST(Oarp, CoversEveryFamilyWhole) {
  for (const auto seed : seeds(2))
    for (const Problem& p : sample_problems(seed))
      for (const Settings& settings : {Settings{}, Settings{{"group", false}, {"compact", false}},
                                       Settings{{"align", std::string("given")}, {"angle", 20.0}}}) {
        SCOPED_TRACE(p.map().source);
        const Path path = plan("oarp", p, settings);
        expect_valid(p, path);
        EXPECT_LE(uncovered_share(p, path, kSamples), 2e-3);
      }
}

// The lanes of a rectangle run along its longer side; the L takes lanes along both arms.
TEST(Oarp, LanesOfARectangleAndAnL) {
  const Settings literal{{"variant", std::string("published")}};
  const auto lanes = [&](const Region& region) {
    const Problem p(Map{"shape", region, "", ""}, disc(0.2, 0.4), Point(0.3, 0.3));
    std::size_t count = 0;
    for (const Leg& leg : plan("oarp", p, literal).legs) count += leg.tool ? 1 : 0;
    return count;
  };
  EXPECT_EQ(lanes(box_region({0, 0}, {8.4, 4.4})), 10u);
  Region l = box_region({0, 0}, {10.4, 10.4});
  l.polygons[0].outer = {{0, 0}, {10.4, 0}, {10.4, 2.4}, {2.4, 2.4}, {2.4, 10.4}, {0, 10.4}};
  EXPECT_EQ(lanes(l), 10u);  // five for each arm, which is two metres wide
}

TEST(Oarp, MoreOriginsNeverNeedMoreLanes) {
  for (const auto seed : seeds(3)) {
    const Problem p(generate("clutter", {{"width", 9.0}, {"height", 7.0}}, seed), Robot{});
    std::map<std::string, double> figures;
    Context::Sinks sinks;
    double lanes = 0;
    sinks.record = [&](const std::string&, double value) { lanes = value; };
    const auto lanes_with = [&](std::int64_t shifts) {
      Context context(1, 1e9, sinks);
      built_in_planner("oarp", {{"shifts", shifts}})->plan(p, context);
      return lanes;
    };
    EXPECT_LE(lanes_with(4), lanes_with(1));
  }
}

}  // namespace
}  // namespace oxturn
