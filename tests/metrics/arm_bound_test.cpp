// Lower bounds of length in narrow maps: never above a path, and near the optimum where that is known.
#include "metrics/arm_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>

#include "base/disjoint_sets.hpp"
#include "base/random.hpp"
#include "geometry/overlay/boolean.hpp"
#include "metrics/score.hpp"
#include "metrics/tour_bound.hpp"
#include "shapes.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

constexpr double kStep = 1.5, kHalf = 0.2006;  // corridors between lattice points, hardly wider than the robot

/// Corridors along the edges of a graph on lattice points.
struct Corridors {
  std::vector<Point> nodes;
  std::vector<std::vector<std::size_t>> next;  // of each node
  double angle = 0;
  double step = kStep;

  explicit Corridors(std::vector<Point> nodes_) : nodes(std::move(nodes_)), next(nodes.size()) {}
  void connect(std::size_t a, std::size_t b) {
    next[a].push_back(b);
    next[b].push_back(a);
  }
  Point at(std::size_t node) const { return rotated(step * nodes[node], angle); }
  Region region() const {
    std::vector<Region> parts;
    for (std::size_t a = 0; a < nodes.size(); ++a)
      for (const std::size_t b : next[a]) {
        const Point low = step * nodes[a].cwiseMin(nodes[b]), high = step * nodes[a].cwiseMax(nodes[b]);
        parts.push_back(box_region(low - Point(kHalf, kHalf), high + Point(kHalf, kHalf)));
      }
    return transformed(unite(parts), angle, {0, 0});
  }
  Problem problem(std::size_t start) const { return problem_in(region(), at(start)); }
};

/// A random tree on a lattice.
Corridors tree(Rng& rng, int columns, int rows) {
  std::vector<Point> nodes;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) nodes.emplace_back(i, j);
  Corridors result(nodes);
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (std::size_t a = 0; a < nodes.size(); ++a)
    for (std::size_t b = a + 1; b < nodes.size(); ++b)
      if (distance(nodes[a], nodes[b]) < 1.1) edges.emplace_back(a, b);
  for (std::size_t k = edges.size(); k > 1; --k) std::swap(edges[k - 1], edges[rng.below(k)]);
  DisjointSets sets(nodes.size());
  for (const auto& [a, b] : edges)
    if (sets.unite(a, b)) result.connect(a, b);
  return result;
}

/// Edges from a node to the farthest one, seen from its parent.
int depth(const Corridors& c, std::size_t node, std::size_t from) {
  int most = 0;
  for (const std::size_t n : c.next[node])
    if (n != from) most = std::max(most, 1 + depth(c, n, node));
  return most;
}

/// Drives into all of a tree; the deepest branches last and not back. Branches for which `skips` is true are left out.
void drive(const Corridors& c, std::size_t node, std::size_t from, bool back, Polyline& line,
           const std::function<bool()>& skips) {
  line.push_back(c.at(node));
  std::vector<std::size_t> others;
  for (const std::size_t n : c.next[node])
    if (n != from && !skips()) others.push_back(n);
  std::ranges::stable_sort(others, {}, [&](std::size_t n) { return depth(c, n, node); });
  for (std::size_t k = 0; k < others.size(); ++k) {
    const bool returns = back || k + 1 < others.size();
    drive(c, others[k], node, returns, line, skips);
    if (returns) line.push_back(c.at(node));
  }
}

constexpr std::size_t kNoNode = 1000;

Score scored(const Problem& problem, const Polyline& line) { return score(problem, work(line)); }

// The shortest path through a tree of corridors as wide as the tool: twice its length, less the path to the farthest
// end. The bound may lose about a tool width for each dead end.
TEST(ArmBound, TreesOfCorridors) {
  for (const auto seed : seeds(12)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Corridors c = tree(rng, rng.between(2, 4), rng.between(2, 4));
    c.angle = rng.between(0.0, 6.0);
    const std::size_t start = rng.below(c.nodes.size());
    Polyline line;
    drive(c, start, kNoNode, false, line, [] { return false; });
    const Score result = scored(c.problem(start), line);
    ASSERT_EQ(result.flaw, "");
    EXPECT_GT(*result.value("coverage"), 0.99);  // a strip along the walls
    EXPECT_LE(*result.value("bound_m"), length(line));
    EXPECT_GT(*result.value("bound_m"), 0.8 * length(line));
  }
}

// Any part of the tree is left out: the bound holds at the coverage that is reached.
TEST(ArmBound, HoldsForPathsThatLeaveOutBranches) {
  for (const auto seed : seeds(60)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Corridors c = tree(rng, rng.between(2, 4), rng.between(2, 4));
    const double share = rng.between(0.05, 0.5);
    const std::size_t start = rng.below(c.nodes.size());
    Polyline line;
    drive(c, start, kNoNode, false, line, [&] { return rng.chance(share); });
    if (line.size() < 2) continue;
    const Score result = scored(c.problem(start), line);
    ASSERT_EQ(result.flaw, "");
    if (const auto bound = result.value("bound_m")) { EXPECT_LE(*bound, length(line)); }
  }
}

// A comb of long aisles: all but one are driven in and out.
TEST(ArmBound, LongDeadEnds) {
  std::vector<Point> nodes;
  for (int i = 0; i < 5; ++i) nodes.emplace_back(i, 0);
  for (int i = 0; i < 5; ++i) nodes.emplace_back(i, 6);
  Corridors c(nodes);
  for (std::size_t i = 0; i < 5; ++i) {
    if (i > 0) c.connect(i - 1, i);
    c.connect(i, i + 5);
  }
  Polyline line;
  drive(c, 0, kNoNode, false, line, [] { return false; });
  const Problem problem = c.problem(0);
  const Score result = scored(problem, line);
  ASSERT_EQ(result.flaw, "");
  EXPECT_EQ(*result.value("bound_kind"), 2);
  EXPECT_LT(*result.value("gap"), 0.1);
  EXPECT_GE(*result.value("gap"), 0);
  // Two of the aisles left out, and none.
  const double whole = *arm_bound(problem, 0, kPi * 0.04), without = *arm_bound(problem, 0.4 * 12, kPi * 0.04);
  EXPECT_LT(without, whole - 2 * 2 * 5.5);
  EXPECT_GT(without, whole - 2 * 2 * 8.5);
}

// From the middle of a corridor: the shorter side twice.
TEST(ArmBound, CorridorWithTwoEnds) {
  Corridors c({{0, 0}, {4, 0}, {10, 0}});
  c.connect(0, 1);
  c.connect(1, 2);
  const Score result = scored(c.problem(1), {c.at(1), c.at(0), c.at(2)});
  ASSERT_EQ(result.flaw, "");
  EXPECT_NEAR(*result.value("bound_m"), 14 * kStep, 0.6);
  EXPECT_LE(*result.value("bound_m"), 14 * kStep);
}

// A loop need not be driven twice: the bound by area holds and is the best.
TEST(ArmBound, Loop) {
  Corridors c({{0, 0}, {4, 0}, {4, 3}, {0, 3}});
  for (std::size_t i = 0; i < 4; ++i) c.connect(i, (i + 1) % 4);
  const Score result = scored(c.problem(0), {c.at(0), c.at(1), c.at(2), c.at(3), c.at(0)});
  ASSERT_EQ(result.flaw, "");
  EXPECT_LE(*result.value("bound_m"), 14 * kStep);
  EXPECT_GT(*result.value("bound_m"), 0.9 * 14 * kStep);
}

// A hall between two dead ends: counts in the arms, area in the hall.
TEST(ArmBound, HallWithArms) {
  std::vector<Region> parts{box_region({0, 0}, {4, 4})};
  for (const double y : {0.0, 4 - 2 * kHalf}) {
    parts.push_back(box_region({-8, y}, {0, y + 2 * kHalf}));
    parts.push_back(box_region({4, y}, {12, y + 2 * kHalf}));
  }
  const Problem problem = problem_in(unite(parts), {2, 2});
  const double area_bound = (area(problem.target()) - kPi * 0.04) / 0.4;
  const auto bound = arm_bound(problem, 0, kPi * 0.04);
  ASSERT_TRUE(bound);
  EXPECT_GT(*bound, area_bound + 3 * 7);  // three arms of 8 m are driven out again
  EXPECT_LT(*bound, area_bound + 3 * 8);
}

TEST(ArmBound, DoesNotDependOnTheFrame) {
  Rng rng(3);
  Corridors c = tree(rng, 4, 3);
  const double upright = *arm_bound(c.problem(0), 0.1, kPi * 0.04);
  c.angle = 1.1;
  EXPECT_NEAR(*arm_bound(c.problem(0), 0.1, kPi * 0.04), upright, 0.02 * upright);
}

// Through the walls of a comb: no bound of valid paths is applied.
TEST(ArmBound, IsNotForPathsThroughWalls) {
  Corridors c({{0, 0}, {4, 0}, {0, 0.4}, {4, 0.4}});
  c.connect(0, 1);
  c.connect(2, 3);
  c.connect(0, 2);
  const Score result = scored(c.problem(2), {c.at(2), c.at(3), c.at(1), c.at(0)});
  EXPECT_NE(result.flaw, "");
  EXPECT_NE(*result.value("bound_kind"), 2);
  EXPECT_GE(*result.value("gap"), 0);
}

struct Orders {
  double costs = 1e9;    // the least sum of distances less the tool's width, or its radius from the start
  double through = 1e9;  // the shortest path through all points
};
/// Of all orders of the points.
Orders best_orders(const Point& start, const std::vector<Point>& at) {
  std::vector<std::size_t> order(at.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  Orders best;
  do {
    double costs = std::max(0.0, distance(start, at[order[0]]) - 0.5), through = distance(start, at[order[0]]);
    for (std::size_t k = 1; k < order.size(); ++k) {
      const double away = distance(at[order[k - 1]], at[order[k]]);
      through += away;
      costs += std::max(0.0, away - 1);
    }
    best = {std::min(best.costs, costs), std::min(best.through, through)};
  } while (std::ranges::next_permutation(order).found);
  return best;
}

// Tiny targets far apart: by brute force over all sets of them, and over all orders of a set.
TEST(TourBound, BruteForce) {
  for (const auto seed : seeds(40)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Region target;
    std::vector<Point> at;
    const int n = rng.between(1, 6);
    for (int k = 0; k < n; ++k) {
      const Point p(rng.between(0.0, 12.0), rng.between(0.0, 12.0));
      if (std::ranges::any_of(at, [&](const Point& q) { return distance(p, q) < 0.1; })) continue;
      at.push_back(p);
      target.polygons.push_back(box_region(p - Point(0.01, 0.01), p + Point(0.01, 0.01)).polygons[0]);
    }
    const Point start(rng.between(0.0, 12.0), rng.between(0.0, 12.0));
    const Orders all = best_orders(start, at);
    double most = 0;  // a part of the points may cost more than all, since each subtracts a tool width
    for (unsigned set = 1; set < 1u << at.size(); ++set) {
      std::vector<Point> some;
      for (std::size_t k = 0; k < at.size(); ++k)
        if (set >> k & 1) some.push_back(at[k]);
      most = std::max(most, best_orders(start, some).costs);
    }
    const double bound = tour_bound(target, 1, 0, start);
    EXPECT_LE(bound, most + 0.03 * n);  // corners of the squares are a little farther from each other
    EXPECT_LE(bound, all.through);
    EXPECT_GE(bound, 0.85 * all.costs - 0.1);
    EXPECT_NEAR(tour_bound(target, 1, area(target), start), 0, 1e-9);  // nothing need be covered
  }
}

}  // namespace
}  // namespace oxturn
