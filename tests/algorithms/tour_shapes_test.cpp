// Elements of drawings, and their matrices of nodes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "algorithms/tour/exact_tour.hpp"
#include "algorithms/tour/node_matrix.hpp"
#include "algorithms/tour/solve_tour.hpp"
#include "tests/support/seeds.hpp"
#include "tests/support/tours.hpp"

namespace oxturn {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TourProblem nodes_of(const ConnectionCost& cost, std::size_t n) {
  return {cost, std::vector<std::size_t>(n, 1), std::vector<PatternId>(n, kNoPattern)};
}

std::vector<std::size_t> order_of(const Tour& tour) {
  std::vector<std::size_t> order;
  for (const TourStop& s : tour) order.push_back(s.element);
  return order;
}

// Figure 2.11 of Vollprecht 2014: a start, a polygon (nodes 2 to 5) and a polyline (6 and 7).
MatrixCost vollprecht() {
  constexpr double oo = kForbidden;
  return {7, {0, 1812, 2097, 1328, 806, 156,  1127,  //
              1, 0,    0,    oo,   oo,  1959, 1489,  //
              1, oo,   0,    0,    oo,  1173, 467,   //
              1, oo,   oo,   0,    0,   698,  993,   //
              1, 0,    oo,   oo,   0,   1717, 1732,  //
              1, 1717, 1959, 1173, 698, 0,    0,     //
              1, 1732, 1489, 467,  993, 0,    0}};
}

TEST(Vollprecht2014, MatrixHasTheOptimum624AndTheNextBest1150) {
  const MatrixCost matrix = vollprecht();
  const TourProblem problem = nodes_of(matrix, 7);
  std::vector<double> costs;
  Tour tour;
  for (std::size_t i = 0; i < 7; ++i) tour.push_back({i, 0});
  do costs.push_back(problem.cost(tour));
  while (std::next_permutation(tour.begin() + 1, tour.end(),
                               [](const TourStop& a, const TourStop& b) { return a.element < b.element; }));
  std::sort(costs.begin(), costs.end());
  EXPECT_EQ(costs[0], 624);
  EXPECT_EQ(costs[1], 1150);
  const std::vector<std::size_t> printed{0, 5, 6, 3, 4, 1, 2};  // 1 6 7 4 5 2 3
  Context context(1);
  EXPECT_EQ(order_of(exact_tour(problem)), printed);
  EXPECT_EQ(order_of(branch_and_bound_tour(problem, 100000).tour), printed);
  EXPECT_EQ(order_of(solve_tour(problem, context, {.exact_if_small = false})), printed);
}

double least_of_matrix(const NodeMatrix& nodes) {
  const MatrixCost matrix = nodes.matrix();
  const TourProblem plain = nodes_of(matrix, nodes.nodes);
  return plain.cost(exact_tour(plain)) - nodes.surplus;
}

// Both forms, the solver itself and the exact tour agree.
TEST(NodeMatrix, WeightShiftingAndDoubleCitiesCostTheSame) {
  int too_low = 0;
  for (const auto seed : seeds(12)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    ShapeTour drawing = random_drawing({}, 2, rng);
    drawing.shapes.push_back(random_shape({.polygons = true}, rng));
    if (drawing.shapes.back().points.size() == 5) drawing.shapes.back().points.pop_back();  // keep exact tours short
    drawing.shapes.push_back({.points = {Point(rng.between(0.0, 100.0), 20), Point(50, rng.between(0.0, 100.0))}});
    const ShapeTourModel model(drawing);
    const TourProblem& problem = model.problem();
    const Tour best = exact_tour(problem);
    const double own = judged_cost(drawing, model.visits(best));
    EXPECT_NEAR(problem.cost(best), own, 1e-9);
    EXPECT_NEAR(least_of_matrix(weight_shifted(problem)), own, 1e-6);
    EXPECT_NEAR(least_of_matrix(double_cities(problem)), own, 1e-6);
    if (least_of_matrix(weight_shifted(problem, ElementConstant::none)) < own - 1e-6) ++too_low;
  }
  EXPECT_GT(too_low, 0);  // as printed, nodes without cost between them are free shortcuts
}

TEST(NodeMatrix, OrdersOfNodesBecomeToursOfShapes) {
  for (const auto seed : seeds(10)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const ShapeTour drawing = random_drawing({.lines = true, .polygons = true}, 12, rng);
    const ShapeTourModel model(drawing);
    for (const NodeMatrix& nodes : {weight_shifted(model.problem()), double_cities(model.problem())}) {
      const MatrixCost matrix = nodes.matrix();
      const TourProblem plain = nodes_of(matrix, nodes.nodes);
      Context context(seed);
      const auto order = order_of(solve_tour(plain, context, {.kicks = 2000}));
      const Tour tour = nodes.tour_of(order, model.problem());
      const double cost = judged_cost(drawing, model.visits(tour));
      EXPECT_NEAR(nodes.cost(order) - nodes.surplus, cost, 1e-5);
      EXPECT_LT(cost, 1.1 * model.problem().cost(solve_tour(model.problem(), context, {.kicks = 2000})));
    }
  }
}

TourShape dot(double x, double y) { return {.points = {Point(x, y)}}; }

// A square round a dot, and another dot outside. Literally, the robot may go from the square to the dot outside and
// then in; strictly, the dot inside comes first.
TEST(ShapeTour, ContainmentIsKeptStrictlyOrAsPrinted) {
  ShapeTour drawing;
  drawing.shapes = {{.points = {{0, 0}, {10, 0}, {10, 10}, {0, 10}}, .closed = true}, dot(9, 5), dot(11, 0)};
  drawing.contained = {{0, 1}};
  drawing.start = Point(0, -1);
  drawing.end = Point(12, 6);
  const auto order = [&](Containment containment) {
    drawing.containment = containment;
    const ShapeTourModel model(drawing);
    std::vector<std::size_t> shapes;
    for (const ShapeVisit& v : model.visits(exact_tour(model.problem()))) shapes.push_back(v.shape);
    return shapes;
  };
  EXPECT_EQ(order(Containment::literal), (std::vector<std::size_t>{0, 2, 1}));
  const auto strict = order(Containment::strict);
  EXPECT_LT(std::find(strict.begin(), strict.end(), 1), std::find(strict.begin(), strict.end(), 0));
}

TEST(ShapeTour, RealConnectionCostsCount) {
  ShapeTour drawing;  // a wall at x = 1 that costs 100 to cross
  drawing.shapes = {dot(0, 0), dot(2, 0), dot(0, 50), dot(2, 50)};
  drawing.start = Point(0, -1);
  drawing.connection = [](const Point& a, const Point& b) {
    return distance(a, b) + ((a.x() < 1) != (b.x() < 1) ? 100 : 0);
  };
  const ShapeTourModel model(drawing);
  Context context(1);
  const auto visits = model.visits(solve_tour(model.problem(), context));
  EXPECT_EQ(visits, (std::vector<ShapeVisit>{{0, 0}, {2, 0}, {3, 0}, {1, 0}}));
}

TEST(ShapeTour, ReturnsToItsStartIfAsked) {
  ShapeTour drawing;
  drawing.shapes = {dot(10, 0), dot(10, 10), dot(0, 10)};
  drawing.start = drawing.end = Point(0, 0);
  const ShapeTourModel model(drawing);
  Context context(1);
  EXPECT_NEAR(model.problem().cost(solve_tour(model.problem(), context)), 40, 1e-12);
}

void expect_refused(const ShapeTour& drawing, const std::string& words) {
  EXPECT_THAT([&] { ShapeTourModel model(drawing); }, ThrowsMessage<std::invalid_argument>(HasSubstr(words)));
}

TEST(ShapeTour, HostileDrawingsAreOneSentence) {
  const TourShape line{.points = {{0, 0}, {1, 0}, {2, 0}}}, square{.points = {{0, 0}, {1, 0}, {1, 1}}, .closed = true};
  expect_refused({}, "has no shapes");
  expect_refused({.shapes = {line, {}}}, "shape 1 has no points");
  expect_refused({.shapes = {line, line}, .joined = {{{0, 1}, {1, 0}}}},
                 "shape 0 is joined at vertex 1, expected an end");
  expect_refused({.shapes = {line}, .joined = {{{0, 0}, {3, 0}}}}, "shape 3 is joined, but there are only 1 shapes");
  expect_refused({.shapes = {line, line, line}, .joined = {{{0, 0}, {1, 0}}, {{2, 0}, {1, 0}}}},
                 "both joined to vertex 0 of polyline 1");
  expect_refused({.shapes = {square, line, line}, .joined = {{{0, 0}, {1, 0}}, {{0, 1}, {2, 0}}}},
                 "polygon 0 is joined at vertices 0 and 1");
  expect_refused(
      {.shapes = {square, line, line, line}, .joined = {{{0, 0}, {1, 0}}, {{0, 0}, {2, 0}}, {{0, 0}, {3, 0}}}},
      "joined to shapes 1, 2 and 3");
  expect_refused({.shapes = {line, line}, .joined = {{{0, 0}, {1, 0}}, {{0, 2}, {1, 2}}}}, "closes a cycle");
  const TourShape one_way{.points = {{0, 0}, {1, 0}}, .one_way = true};
  expect_refused({.shapes = {one_way, one_way}, .joined = {{{0, 1}, {1, 1}}}}, "in neither direction");
  expect_refused({.shapes = {one_way, one_way}, .joined = {{{0, 1}, {1, 0}}}, .contained = {{0, 1}}},
                 "in neither direction");
  expect_refused({.shapes = {line, line}, .contained = {{0, 5}}}, "shape 0 cannot contain shape 5");
}

}  // namespace
}  // namespace oxturn
