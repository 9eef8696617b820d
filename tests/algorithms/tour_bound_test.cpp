// Lower bounds of tours, and the assignments they begin with.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "algorithms/tour/assignment.hpp"
#include "algorithms/tour/exact_tour.hpp"
#include "algorithms/tour/held_karp_bound.hpp"
#include "algorithms/tour/one_tree.hpp"
#include "algorithms/tour/tour_start.hpp"
#include "tests/support/seeds.hpp"
#include "tests/support/tours.hpp"

namespace oxturn {
namespace {

std::vector<double> random_costs(std::size_t n, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<double> costs(n * n);
  for (double& c : costs) c = rng.between(0.0, 100.0);
  return costs;
}

TourProblem directed(const ConnectionCost& cost, std::size_t n) {
  return {cost, std::vector<std::size_t>(n, 1), std::vector<PatternId>(n, kNoPattern)};
}

TEST(Assignment, EqualsBruteForceAndItsPricesProveIt) {
  for (const auto seed : seeds(40)) {
    SCOPED_TRACE(seed);
    const std::size_t n = 2 + seed % 6;
    const auto costs = random_costs(n, seed);
    const Assignment a = solve_assignment(n, [&](std::size_t i, std::size_t j) { return costs[i * n + j]; });
    std::vector<std::size_t> columns(n);
    std::iota(columns.begin(), columns.end(), 0);
    double least = 1e300, cost = 0, prices = 0;
    do {
      double sum = 0;
      for (std::size_t i = 0; i < n; ++i) sum += costs[i * n + columns[i]];
      least = std::min(least, sum);
    } while (std::next_permutation(columns.begin(), columns.end()));
    for (std::size_t i = 0; i < n; ++i) {
      cost += costs[i * n + a.column[i]];
      prices += a.row_price[i] + a.column_price[i];
      for (std::size_t j = 0; j < n; ++j) EXPECT_LE(a.row_price[i] + a.column_price[j], costs[i * n + j] + 1e-9);
    }
    EXPECT_NEAR(cost, least, 1e-9);
    EXPECT_NEAR(prices, least, 1e-9);
  }
}

TEST(Assignment, PatchedCyclesAreATour) {
  for (const auto seed : seeds(10)) {
    const MatrixCost matrix(40, random_costs(40, seed));
    const TourProblem problem = directed(matrix, 40);
    const Tour tour = patched_assignment_tour(problem);
    std::vector<bool> seen(40, false);
    for (const TourStop& s : tour) seen[s.element] = true;
    EXPECT_EQ(tour.size(), 40u);
    EXPECT_EQ(std::count(seen.begin(), seen.end(), true), 40);
    EXPECT_LT(problem.cost(tour), problem.cost(nearest_neighbour_tour(problem)));
  }
}

TEST(OneTree, SparseEqualsCompleteOnACompleteGraph) {
  for (const auto seed : seeds(10)) {
    const auto costs = random_costs(20, seed);
    const EdgeCost cost = [&](ElementId a, ElementId b) { return costs[std::min(a, b) * 20 + std::max(a, b)]; };
    SparseGraph graph(20);
    for (ElementId a = 0; a < 20; ++a)
      for (ElementId b = 0; b < 20; ++b)
        if (a != b) graph[a].push_back(b);
    EXPECT_NEAR(sparse_one_tree(graph, cost).cost, complete_one_tree(20, cost).cost, 1e-9);
    EXPECT_EQ(complete_one_tree(20, cost).edges.size(), 20u);
  }
}

TEST(HeldKarpBound, IsBelowTheOptimumOfEveryKind) {
  for (const DrawingKind& kind : drawing_kinds())
    for (const auto seed : seeds(4)) {
      SCOPED_TRACE(fmt::format("kind {} seed {}", &kind - &drawing_kinds()[0], seed));
      Rng rng(seed);
      const ShapeTourModel model(random_drawing(kind, 9, rng));
      const double optimum = model.problem().cost(exact_tour(model.problem()));
      EXPECT_LE(held_karp_bound(model.problem(), optimum), optimum + 1e-6);
    }
}

TEST(HeldKarpBound, IsCloseToTheOptimumOfPlainTours) {
  double points = 0, matrices = 0;
  for (const auto seed : seeds(10)) {
    Rng rng(seed);
    std::vector<Point> at(11);
    for (Point& p : at) p = Point(rng.between(0.0, 1.0), rng.between(0.0, 1.0));
    const StraightCost straight(at);
    const TourProblem plain(straight, 11);
    const double optimum = plain.cost(exact_tour(plain)), bound = held_karp_bound(plain, optimum);
    EXPECT_LE(bound, optimum + 1e-9);
    points += bound / optimum / 10;
    const MatrixCost matrix(11, random_costs(11, seed));
    const TourProblem asymmetric = directed(matrix, 11);
    const double least = asymmetric.cost(exact_tour(asymmetric)), below = held_karp_bound(asymmetric, least);
    EXPECT_LE(below, least + 1e-9);
    const Assignment assignment = solve_assignment(11, [&](std::size_t i, std::size_t j) {
      return i == j ? kForbidden : matrix(static_cast<PatternId>(i), static_cast<PatternId>(j));
    });
    double cheapest = 0;
    for (std::size_t i = 0; i < 11; ++i)
      cheapest += matrix(static_cast<PatternId>(i), static_cast<PatternId>(assignment.column[i]));
    EXPECT_GE(below, cheapest - 1e-6);
    matrices += below / least / 10;
  }
  EXPECT_GT(points, 0.985);
  EXPECT_GT(matrices, 0.97);
}

// The same costs both ways: the asymmetric form must find about the same bound.
TEST(HeldKarpBound, AsymmetricFormAgreesOnSymmetricCosts) {
  Rng rng(1);
  std::vector<Point> at(60);
  for (Point& p : at) p = Point(rng.between(0.0, 1.0), rng.between(0.0, 1.0));
  const StraightCost straight(at);
  const TourProblem plain(straight, at.size()), asymmetric = directed(straight, at.size());
  const double tour = plain.cost(nearest_neighbour_tour(plain));
  EXPECT_NEAR(held_karp_bound(asymmetric, tour) / held_karp_bound(plain, tour), 1, 0.01);
}

}  // namespace
}  // namespace oxturn
