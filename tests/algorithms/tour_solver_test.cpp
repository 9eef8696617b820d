// The tour solver, against exact tours, an independent judge, and its own promises.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "algorithms/tour/exact_tour.hpp"
#include "algorithms/tour/held_karp_bound.hpp"
#include "algorithms/tour/pattern_choice.hpp"
#include "algorithms/tour/solve_tour.hpp"
#include "algorithms/tour/tour_moves.hpp"
#include "algorithms/tour/tour_start.hpp"
#include "tests/support/dubins.hpp"
#include "tests/support/seeds.hpp"
#include "tests/support/tours.hpp"

namespace oxturn {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::vector<Point> random_points(std::size_t n, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Point> points;
  while (points.size() < n) {
    const double x = rng.unit();
    points.push_back({x, rng.unit()});
  }
  return points;
}

/// Each element has one pattern, which cannot be driven backwards.
TourProblem directed(const ConnectionCost& cost, std::size_t n) {
  return {cost, std::vector<std::size_t>(n, 1), std::vector<PatternId>(n, kNoPattern)};
}

MatrixCost random_matrix(std::size_t n, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<double> costs(n * n);
  for (double& c : costs) c = static_cast<double>(rng.below(1000));
  return {n, std::move(costs)};
}

/// A problem with any number of patterns and any costs, and now and then precedence.
struct RandomClusters {
  RandomClusters(std::size_t n, std::uint64_t seed) : rng(mix(seed, "clusters")) {
    std::vector<std::size_t> counts;
    std::vector<PatternId> reverse;
    std::vector<double> inner;
    for (std::size_t e = 0; e < n; ++e) {
      counts.push_back(1 + rng.below(4));
      for (std::size_t p = 0; p < counts.back(); ++p) {
        reverse.push_back(kNoPattern);
        inner.push_back(static_cast<double>(rng.below(100)));
      }
    }
    matrix.emplace(random_matrix(reverse.size(), seed));
    problem.emplace(*matrix, counts, reverse, inner);
    for (ElementId e = 1; seed % 3 == 0 && e + 1 < n; e += 2) problem->require_before(e, e + 1);
  }
  Rng rng;
  std::optional<MatrixCost> matrix;
  std::optional<TourProblem> problem;
};

void expect_valid(const TourProblem& problem, const Tour& tour) {
  ASSERT_EQ(tour.size(), problem.elements());
  EXPECT_EQ(tour[0].element, 0u);
  std::vector<std::size_t> position(tour.size(), tour.size());
  for (std::size_t i = 0; i < tour.size(); ++i) {
    EXPECT_EQ(position[tour[i].element], tour.size());
    EXPECT_LT(tour[i].pattern, problem.pattern_count(static_cast<ElementId>(tour[i].element)));
    position[tour[i].element] = i;
  }
  for (ElementId e = 0; e < tour.size(); ++e)
    for (const ElementId later : problem.after(e)) EXPECT_LT(position[e], position[later]);
}

/// By trying all orders and all patterns.
double brute_force(const TourProblem& problem) {
  std::vector<std::size_t> order(problem.elements() - 1);
  std::iota(order.begin(), order.end(), 1);
  double best = 1e300;
  do {
    bool allowed = true;
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (const ElementId later : problem.after(static_cast<ElementId>(order[i]))) allowed &= later != order[j];
    if (!allowed) continue;
    Tour tour{{0, 0}};
    for (const std::size_t e : order) tour.push_back({e, 0});
    for (bool more = true; more;) {
      best = std::min(best, problem.cost(tour));
      more = false;
      for (TourStop& s : tour) {
        const std::size_t count = problem.pattern_count(static_cast<ElementId>(s.element));
        if (s.element == 0 && problem.has_direction()) continue;
        s.pattern = (s.pattern + 1) % count;
        if (s.pattern != 0) {
          more = true;
          break;
        }
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

TEST(ExactTour, EqualsBruteForce) {
  for (const auto seed : seeds(12)) {
    SCOPED_TRACE(seed);
    const RandomClusters clusters(5, seed);
    const Tour tour = exact_tour(*clusters.problem);
    expect_valid(*clusters.problem, tour);
    EXPECT_NEAR(clusters.problem->cost(tour), brute_force(*clusters.problem), 1e-9);
  }
}

TEST(ExactTour, BranchAndBoundAgreesAndBeginsWithNearestNeighbours) {
  for (const auto seed : seeds(20)) {
    SCOPED_TRACE(seed);
    const RandomClusters clusters(7, seed);
    const BoundedTour found = branch_and_bound_tour(*clusters.problem, 10000000);
    expect_valid(*clusters.problem, found.tour);
    EXPECT_TRUE(found.proven);
    EXPECT_NEAR(clusters.problem->cost(found.tour), clusters.problem->cost(exact_tour(*clusters.problem)), 1e-9);
    const MatrixCost matrix = random_matrix(30, seed);
    const TourProblem plain = directed(matrix, 30);
    const BoundedTour first = branch_and_bound_tour(plain, 1);
    EXPECT_FALSE(first.proven);
    EXPECT_EQ(first.tour, nearest_neighbour_tour(plain));
  }
}

// The local search itself, kept from exact tours, on drawings of every kind.
TEST(SolveTour, IsOptimalOnSmallDrawingsOfEveryKind) {
  for (const DrawingKind& kind : drawing_kinds())
    for (const auto seed : seeds(8)) {
      SCOPED_TRACE(fmt::format("kind {} seed {}", &kind - &drawing_kinds()[0], seed));
      Rng rng(seed);
      const ShapeTour drawing = random_drawing(kind, 4 + seed, rng);
      const ShapeTourModel model(drawing);
      Context context(seed);
      const Tour tour = solve_tour(model.problem(), context, {.kicks = 3000, .exact_if_small = false});
      expect_valid(model.problem(), tour);
      const double cost = model.problem().cost(tour);
      EXPECT_NEAR(cost, judged_cost(drawing, model.visits(tour)), 1e-6);
      EXPECT_NEAR(cost, model.problem().cost(exact_tour(model.problem())), 1e-6);
    }
}

TEST(SolveTour, IsOptimalOnSmallMatrices) {
  for (const auto seed : seeds(20)) {
    SCOPED_TRACE(seed);
    const MatrixCost matrix = random_matrix(11, seed);
    const TourProblem plain = directed(matrix, 11);
    const RandomClusters clusters(9, seed);
    Context context(seed);
    const Tour tour = solve_tour(plain, context, {.kicks = 5000, .exact_if_small = false});
    expect_valid(plain, tour);
    EXPECT_NEAR(plain.cost(tour), plain.cost(exact_tour(plain)), 1e-9);
    const Tour small = solve_tour(*clusters.problem, context);  // exact
    const Tour searched = solve_tour(*clusters.problem, context, {.kicks = 1000, .exact_if_small = false});
    expect_valid(*clusters.problem, searched);
    EXPECT_NEAR(clusters.problem->cost(small), clusters.problem->cost(exact_tour(*clusters.problem)), 1e-9);
    EXPECT_GE(clusters.problem->cost(searched), clusters.problem->cost(small) - 1e-9);
  }
}

TEST(SolveTour, KeepsEveryDemandOfLargeDrawings) {
  for (const DrawingKind& kind : drawing_kinds()) {
    Rng rng(7);
    const ShapeTour drawing = random_drawing(kind, 150, rng);
    const ShapeTourModel model(drawing);
    Context context(1);
    const Tour first = solve_tour(model.problem(), context, {.kicks = 0});
    const Tour tour = solve_tour(model.problem(), context, {.kicks = 1500});
    EXPECT_NEAR(model.problem().cost(tour), judged_cost(drawing, model.visits(tour)), 1e-6);
    EXPECT_LE(model.problem().cost(tour), model.problem().cost(first) + 1e-9);
  }
}

TEST(SolveTour, IsWithinTwoPercentOfTheBound) {
  const StraightCost cost(random_points(400, 1));
  const TourProblem problem(cost, 400);
  Context context(1);
  const double length = problem.cost(solve_tour(problem, context, {.kicks = 8000}));
  EXPECT_LT(length, 1.02 * held_karp_bound(problem, length));
}

// Far clusters on a circle: the nearest neighbours of a point are all in its own, yet each is visited in one run.
TEST(SolveTour, LeavesEachClusterOnce) {
  constexpr std::size_t kClusters = 12;
  Rng rng(1);
  std::vector<Point> points;
  for (std::size_t i = 0; i < 300; ++i) {
    const double angle = 2 * 3.14159265 * static_cast<double>(i % kClusters) / kClusters;
    points.push_back({std::cos(angle) + 0.01 * rng.normal(), std::sin(angle) + 0.01 * rng.normal()});
  }
  const StraightCost cost(points);
  const TourProblem problem(cost, points.size());
  Context context(1);
  const Tour tour = solve_tour(problem, context, {.kicks = 8000});
  std::size_t changes = 0;
  for (std::size_t i = 0; i < tour.size(); ++i)
    if (tour[i].element % kClusters != tour[(i + 1) % tour.size()].element % kClusters) ++changes;
  EXPECT_EQ(changes, kClusters);
}

TEST(SolveTour, IsWithinTwoPercentOfTheBoundForDirectedCurves) {
  Rng rng(3);
  std::vector<DirectedPoint> poses;
  for (const Point& p : random_points(200, 2)) poses.push_back({p, rng.between(0.0, 6.28)});
  const FunctionCost curves([&](PatternId a, PatternId b) { return dubins_length(poses[a], poses[b], 0.05); }, false);
  const MatrixCost table = tabulate(curves, poses.size());
  const TourProblem problem = directed(table, poses.size());
  Context context(1);
  const double length = problem.cost(solve_tour(problem, context, {.kicks = 4000}));
  EXPECT_LT(length, 1.02 * held_karp_bound(problem, length));
}

TEST(SolveTour, SameEffortSameTour) {
  const StraightCost cost(random_points(200, 5));
  const TourProblem problem(cost, 200);
  Context a(9), b(9);
  EXPECT_EQ(solve_tour(problem, a, {.kicks = 1000}), solve_tour(problem, b, {.kicks = 1000}));
}

TEST(SolveTour, PublishesBetterAndBetterToursAndEndsWhenCancelled) {
  const StraightCost cost(random_points(300, 6));
  const TourProblem problem(cost, 300);
  Context context(1);
  double last = 1e300;
  int published = 0;
  const Tour tour = solve_tour(problem, context, {.kicks = 1000000, .improved = [&](const Tour& t) {
                                                    EXPECT_LT(problem.cost(t), last);
                                                    last = problem.cost(t);
                                                    if (++published == 5) context.cancel();
                                                  }});
  EXPECT_EQ(published, 5);
  expect_valid(problem, tour);
  EXPECT_NEAR(problem.cost(tour), last, 1e-12);
}

TEST(SolveTour, NeverMakesAGivenTourDearer) {
  for (const auto seed : seeds(5)) {
    const RandomClusters clusters(30, seed);
    const Tour first = nearest_neighbour_tour(*clusters.problem);
    Context context(seed);
    const Tour tour = improved_tour(*clusters.problem, first, context, {.kicks = 200});
    expect_valid(*clusters.problem, tour);
    EXPECT_LE(clusters.problem->cost(tour), clusters.problem->cost(first) + 1e-9);
  }
}

TEST(SolveTour, OneToThreeElements) {
  for (std::size_t n = 1; n <= 3; ++n) {
    const StraightCost cost(random_points(n, n));
    const TourProblem problem(cost, n);
    Context context(1);
    expect_valid(problem, solve_tour(problem, context));
    expect_valid(problem, improved_tour(problem, solve_tour(problem, context), context));
  }
}

TEST(SolveTour, CopesWithEqualPoints) {
  const StraightCost cost(std::vector<Point>(60, Point(1, 1)));
  const TourProblem problem(cost, 60);
  Context context(1);
  const Tour tour = solve_tour(problem, context, {.kicks = 100});
  expect_valid(problem, tour);
  EXPECT_EQ(problem.cost(tour), 0);
}

TEST(SolveTour, HostileProblemsAreOneSentence) {
  const MatrixCost matrix = random_matrix(4, 1);
  TourProblem cycle = directed(matrix, 4);
  cycle.require_before(1, 2);
  cycle.require_before(2, 1);
  Context context(1);
  EXPECT_THAT([&] { solve_tour(cycle, context); }, ThrowsMessage<std::invalid_argument>(HasSubstr("in a cycle")));
  EXPECT_THAT([&] { cycle.require_before(0, 1); },
              ThrowsMessage<std::invalid_argument>(HasSubstr("element 0 cannot be required before element 1")));
  EXPECT_THAT(
      [] {
        MatrixCost(2, {0, 1, 2});
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("3 values, expected 4")));
  const MatrixCost forbidden(5, std::vector<double>(25, kForbidden));
  const TourProblem none = directed(forbidden, 5);
  EXPECT_THROW(solve_tour(none, context), Infeasible);
}

// What the moves say they have gained is what the tour has become cheaper by.
TEST(TourMoves, GainsAreExact) {
  for (const auto seed : seeds(30)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const ShapeTour drawing = random_drawing(drawing_kinds()[seed % drawing_kinds().size()], 40, rng);
    const ShapeTourModel model(drawing);
    const RandomClusters clusters(25, seed);
    for (const TourProblem* problem : {&model.problem(), &*clusters.problem}) {
      const Tour first = nearest_neighbour_tour(*problem);
      TourState state(*problem, first);
      const NeighbourLists lists(*problem, 6);
      MoveSearch search(*problem, lists, state);
      for (int round = 0; round < 200; ++round) {
        const auto a = static_cast<ElementId>(rng.below(problem->elements()));
        const bool moved = problem->symmetric() && round % 2 == 0 ? three_opt(search, a, round % 4 == 0)
                           : round % 3 == 0                       ? or_three_opt(search, a)
                           : round % 3 == 1                       ? reinsert(search, a)
                                                                  : change_pattern(search, a);
        if (moved) { ASSERT_NEAR(problem->cost(first) - search.gained, problem->cost(state.tour()), 1e-6) << round; }
      }
      expect_valid(*problem, state.tour());
      state.undo();
      EXPECT_EQ(state.tour(), TourState(*problem, first).tour());
    }
  }
}

TEST(PatternChoice, IsTheBestForTheOrder) {
  for (const auto seed : seeds(20)) {
    const RandomClusters clusters(6, seed);
    const Tour tour = nearest_neighbour_tour(*clusters.problem);
    Tour other = tour;
    for (TourStop& s : other) s.pattern = 0;
    double least = 1e300;
    for (bool more = true; more;) {
      least = std::min(least, clusters.problem->cost(other));
      more = false;
      for (TourStop& s : other) {
        s.pattern = (s.pattern + 1) % clusters.problem->pattern_count(static_cast<ElementId>(s.element));
        if (s.pattern != 0) {
          more = true;
          break;
        }
      }
    }
    EXPECT_NEAR(clusters.problem->cost(best_patterns(*clusters.problem, tour)), least, 1e-9);
  }
}

}  // namespace
}  // namespace oxturn
