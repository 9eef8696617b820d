#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "algorithms/tour/generalised_tour.hpp"
#include "algorithms/tour/open_tour.hpp"
#include "algorithms/tour/quadrant_tree.hpp"
#include "geometry/point_grid.hpp"
#include "tests/support/drawn.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

Problem hall() { return Problem(Map{"hall", box_region({0, 0}, {20, 20}), "", ""}, Robot{}, Point(10, 10)); }

TourElement segment(const Point& a, const Point& b) { return {{a, b, 0, 1}, {b, a, 0, 0}}; }

std::vector<TourElement> random_segments(std::size_t n, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<TourElement> all;
  for (std::size_t i = 0; i < n; ++i) {
    const Point a(rng.between(1.0, 19.0), rng.between(1.0, 19.0)), b(rng.between(1.0, 19.0), rng.between(1.0, 19.0));
    all.push_back(segment(a, a + 0.2 * (b - a)));
  }
  return all;
}

double straight_cost(const Point& start, const std::vector<TourElement>& elements, const std::vector<TourStop>& tour) {
  double sum = 0;
  Point at = start;
  for (const TourStop& s : tour) {
    const Pattern& p = elements[s.element][s.pattern];
    sum += distance(at, p.entry) + p.cost;
    at = p.exit;
  }
  return sum;
}

// By brute force: all orders and all directions.
double least_cost(const Point& start, const std::vector<TourElement>& elements) {
  std::vector<TourStop> tour(elements.size());
  std::vector<std::size_t> order(elements.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  double best = 1e300;
  do {
    for (std::size_t bits = 0; bits < std::size_t{1} << order.size(); ++bits) {
      for (std::size_t i = 0; i < order.size(); ++i) tour[i] = {order[i], bits >> i & 1};
      best = std::min(best, straight_cost(start, elements, tour));
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

void expect_each_once(const std::vector<TourStop>& tour, std::size_t n) {
  std::set<std::size_t> seen;
  for (const TourStop& s : tour) seen.insert(s.element);
  EXPECT_EQ(tour.size(), n);
  EXPECT_EQ(seen.size(), n);
}

TEST(OpenTour, ImprovedToursAreNearlyOptimal) {
  const Problem p = hall();
  const Connector connector(p);
  double ratio = 0;
  for (const auto seed : seeds(20)) {
    const auto elements = random_segments(6, seed);
    const TourCosts costs(p.start(), elements, connector);
    Context context;
    auto tour = nearest_tour(costs, p, context);
    expect_each_once(tour, 6);
    const double first = cost_of(costs, tour);
    EXPECT_NEAR(first, straight_cost(p.start(), elements, tour), 1e-9);
    improve_tour(costs, tour, context);
    choose_patterns(costs, tour);
    expect_each_once(tour, 6);
    const double least = least_cost(p.start(), elements);
    EXPECT_LE(cost_of(costs, tour), first + 1e-9);
    EXPECT_GE(cost_of(costs, tour), least - 1e-9);
    ratio += cost_of(costs, tour) / least / 20;
  }
  EXPECT_LT(ratio, 1.05);
}

TEST(OpenTour, PatternsAreTheBestForTheOrder) {
  const Problem p = hall();
  const Connector connector(p);
  for (const auto seed : seeds(20)) {
    const auto elements = random_segments(7, seed);
    const TourCosts costs(p.start(), elements, connector);
    std::vector<TourStop> tour;
    for (std::size_t i = 0; i < 7; ++i) tour.push_back({i, 0});
    double least = 1e300;
    for (std::size_t bits = 0; bits < 128; ++bits) {
      std::vector<TourStop> other = tour;
      for (std::size_t i = 0; i < 7; ++i) other[i].pattern = bits >> i & 1;
      least = std::min(least, straight_cost(p.start(), elements, other));
    }
    choose_patterns(costs, tour);
    EXPECT_NEAR(cost_of(costs, tour), least, 1e-9);
  }
}

TEST(OpenTour, ImprovingShortensAndKeepsEveryElement) {
  const Problem p = hall();
  const Connector connector(p);
  for (const auto seed : seeds(5)) {
    const auto elements = random_segments(120, seed);
    const TourCosts costs(p.start(), elements, connector);
    Context context;
    auto tour = nearest_tour(costs, p, context);
    const double first = cost_of(costs, tour);
    improve_tour(costs, tour, context);
    expect_each_once(tour, 120);
    EXPECT_LT(cost_of(costs, tour), first * 0.97);
  }
}

TEST(OpenTour, DepthFirstGoesToNeighboursWhileThereAreAny) {
  const Problem p = hall();
  const Connector connector(p);
  const auto elements = random_segments(30, 3);
  std::vector<std::vector<std::size_t>> ring(30);  // a cycle: depth-first must follow it
  for (std::size_t i = 0; i < 30; ++i) ring[i] = {(i + 1) % 30, (i + 29) % 30};
  Context context;
  const auto tour = depth_first_tour(TourCosts(p.start(), elements, connector), p, ring, context);
  expect_each_once(tour, 30);
  int jumps = 0;
  for (std::size_t i = 1; i < tour.size(); ++i) {
    const std::size_t d = (tour[i].element + 30 - tour[i - 1].element) % 30;
    if (d != 1 && d != 29) ++jumps;
  }
  EXPECT_EQ(jumps, 0);
}

// The nearest by straight distance lies behind a wall.
TEST(OpenTour, NearestMeasuresPathsAroundWalls) {
  const Problem p = drawn({".......", "...#...", "...#...", "..S#..."});
  const Connector connector(p);
  const std::vector<TourElement> elements{segment({4.3, 0.5}, {4.3, 0.7}), segment({0.3, 0.5}, {0.3, 0.7})};
  Context context;
  const auto tour = nearest_tour(TourCosts(p.start(), elements, connector), p, context);
  ASSERT_EQ(tour.size(), 2u);
  EXPECT_EQ(tour[0].element, 1u);
}

// In an apartment most elements are behind walls. Choosing patterns never makes the tour clearly longer, although far
// jumps are compared by one path, and the whole order asks for few exact paths.
TEST(OpenTour, FarElementsCostFewSearches) {
  for (const auto seed : seeds(5)) {
    const Problem p(generate("rooms", {{"width", 30.0}, {"height", 30.0}, {"rooms", std::int64_t{45}}}, seed), Robot{});
    const Connector connector(p);
    Rng rng(seed);
    std::vector<TourElement> elements;
    while (elements.size() < 150) {
      const Point a(rng.between(0.0, 30.0), rng.between(0.0, 30.0)), b = a + Point(0.5, 0.3);
      if (p.walls().contains(a, b)) elements.push_back(segment(a, b));
    }
    const TourCosts costs(p.start(), elements, connector);
    Context context;
    auto tour = nearest_tour(costs, p, context);
    expect_each_once(tour, 150);
    EXPECT_EQ(costs.searches(), 0u);
    choose_patterns(costs, tour);
    EXPECT_LT(costs.searches(), 600u);
    const double first = cost_of(costs, tour);
    improve_tour(costs, tour, context);
    expect_each_once(tour, 150);
    EXPECT_LE(cost_of(costs, tour), first + 1e-9);
    const double improved = cost_of(costs, tour);
    choose_patterns(costs, tour);
    EXPECT_LE(cost_of(costs, tour), 1.005 * improved);
  }
}

TEST(PointGrid, VisitsInOrderOfDistance) {
  Rng rng(4);
  std::vector<Point> points;
  for (int i = 0; i < 300; ++i) points.push_back({rng.between(0.0, 50.0), rng.between(0.0, 3.0)});
  PointGrid grid(points);
  for (std::size_t i = 0; i < 300; i += 3) grid.remove(i);
  for (int q = 0; q < 50; ++q) {
    const Point p(rng.between(-20.0, 70.0), rng.between(-20.0, 20.0));
    std::vector<double> seen, wanted;
    grid.visit(p, [&](std::size_t, double d) {
      seen.push_back(d);
      return true;
    });
    for (std::size_t i = 0; i < 300; ++i)
      if (i % 3 != 0) wanted.push_back(distance(p, points[i]));
    std::sort(wanted.begin(), wanted.end());
    EXPECT_EQ(seen, wanted);
  }
}

TEST(QuadrantTree, FindsTheTwoNearestInEachQuadrant) {
  Rng rng(5);
  std::vector<Point> points;
  for (int i = 0; i < 200; ++i) points.push_back({std::floor(rng.between(0.0, 30.0)), rng.between(0.0, 3.0)});
  const QuadrantTree tree(points);
  for (std::size_t q = 0; q < points.size(); ++q) {
    const auto others = [&](std::size_t i) { return i != q; };
    std::vector<double> found, wanted;
    for (const std::size_t i : tree.nearest(points[q], others)) found.push_back(distance(points[q], points[i]));
    for (const bool right : {false, true})
      for (const bool above : {false, true}) {
        std::vector<double> all;
        for (std::size_t i = 0; i < points.size(); ++i)
          if (i != q && (points[i].x() >= points[q].x()) == right && (points[i].y() >= points[q].y()) == above)
            all.push_back(distance(points[q], points[i]));
        std::sort(all.begin(), all.end());
        wanted.insert(wanted.end(), all.begin(),
                      all.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(2, all.size())));
      }
    std::sort(found.begin(), found.end());
    std::sort(wanted.begin(), wanted.end());
    ASSERT_EQ(found.size(), wanted.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 1e-12);
  }
}

}  // namespace
}  // namespace oxturn
