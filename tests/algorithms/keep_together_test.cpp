// Clustered tours: groups stay together, and small ones are as short as trying all orders finds.
#include "algorithms/tour/keep_together.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>

#include "algorithms/tour/solve_tour.hpp"
#include "base/random.hpp"

namespace oxturn {
namespace {

std::vector<Point> random_points(std::size_t n, Rng& rng) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < n; ++i) points.emplace_back(rng.between(0.0, 100.0), rng.between(0.0, 100.0));
  return points;
}

/// No group that was left is entered again. The order is a cycle.
bool kept(const std::vector<std::size_t>& order, const std::vector<std::size_t>& groups) {
  std::size_t changes = 0;
  std::set<std::size_t> named;
  std::size_t alone = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t a = groups[order[i]], b = groups[order[(i + 1) % order.size()]];
    changes += a != b || a == kNoGroup;
    if (a == kNoGroup)
      ++alone;
    else
      named.insert(a);
  }
  const std::size_t blocks = named.size() + alone;
  return changes == (blocks > 1 || alone > 0 ? blocks : 0);
}

double length_of(const std::vector<std::size_t>& order, const std::vector<Point>& points) {
  double sum = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
    sum += distance(points[order[i]], points[order[(i + 1) % order.size()]]);
  return sum;
}

std::vector<std::size_t> solve(const std::vector<Point>& points, const std::vector<std::size_t>& groups) {
  const StraightCost straight(points);
  const KeepTogether cost(straight, groups);
  const TourProblem problem(cost, points.size());
  Context context;
  std::vector<std::size_t> order;
  for (const TourStop& stop : solve_tour(problem, context, {.kicks = 2000})) order.push_back(stop.element);
  return order;
}

TEST(KeepTogether, SmallToursAreOptimal) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Rng rng(seed);
    const std::vector<Point> points = random_points(8, rng);
    std::vector<std::size_t> groups;
    for (std::size_t i = 0; i < points.size(); ++i) groups.push_back(rng.chance(0.2) ? kNoGroup : rng.below(3));
    const auto order = solve(points, groups);
    ASSERT_TRUE(kept(order, groups)) << seed;
    std::vector<std::size_t> other(points.size());
    std::iota(other.begin(), other.end(), std::size_t{0});
    double best = 1e300;
    do
      if (kept(other, groups)) best = std::min(best, length_of(other, points));
    while (std::next_permutation(other.begin() + 1, other.end()));
    ASSERT_NEAR(length_of(order, points), best, 1e-9) << seed;
  }
}

TEST(KeepTogether, LargerToursKeepTheirGroups) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Rng rng(seed);
    const std::vector<Point> points = random_points(200, rng);
    std::vector<std::size_t> groups;
    for (std::size_t i = 0; i < points.size(); ++i) groups.push_back(i % 10 == 0 ? kNoGroup : rng.below(12));
    ASSERT_TRUE(kept(solve(points, groups), groups)) << seed;
  }
}

TEST(KeepTogether, CostsWithoutExactSumsAreRefused) {
  const StraightCost straight(std::vector<Point>{{0, 0}, {1e11, 0}, {5, 5}});
  EXPECT_THROW(KeepTogether(straight, {0, 0, 1}), std::invalid_argument);
}

}  // namespace
}  // namespace oxturn
