// TSPLIB files and LKH.
#include "algorithms/tour/tsplib.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>

#include "algorithms/tour/exact_tour.hpp"
#include "algorithms/tour/lkh.hpp"
#include "algorithms/tour/solve_tour.hpp"
#include "base/files.hpp"
#include "tests/support/files.hpp"
#include "tests/support/tours.hpp"

namespace oxturn {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(Tsplib, ReadsPoints) {
  const auto instance = read_tsplib(
      "NAME : three\nCOMMENT : any text: here\nTYPE: TSP\nDIMENSION : 3\nEDGE_WEIGHT_TYPE : EUC_2D\n"
      "NODE_COORD_SECTION\n1 0 0\n3 0 4.6\n2 3.0e0 0\nEOF\n",
      "three.tsp");
  EXPECT_EQ(instance.name, "three");
  EXPECT_TRUE(instance.symmetric);
  const auto cost = instance.cost();
  EXPECT_EQ((*cost)(0, 1), 3);
  EXPECT_EQ((*cost)(0, 2), 5);  // 4.6 rounded
  EXPECT_EQ((*cost)(1, 2), 5);  // 5.49
}

TEST(Tsplib, ReadsMatrices) {
  const auto instance = read_tsplib(
      "name: a\ntype: atsp\ndimension: 2\nedge_weight_type: explicit\nedge_weight_format: full_matrix\n"
      "edge_weight_section\n 9999 1\n 2 9999",
      "a.atsp");
  EXPECT_FALSE(instance.symmetric);
  EXPECT_EQ(instance.matrix, (std::vector<double>{0, 1, 2, 0}));
  const auto cost = instance.cost();
  EXPECT_EQ((*cost)(1, 0), 2);
}

TEST(Tsplib, WhatIsWrittenReadsBack) {
  Rng rng(1);
  TsplibInstance points{.name = "p", .weights = TsplibInstance::Weights::ceil_2d};
  TsplibInstance matrix{.name = "m", .symmetric = false, .weights = TsplibInstance::Weights::full_matrix};
  points.dimension = matrix.dimension = 12;
  for (int i = 0; i < 12; ++i) points.points.push_back({rng.between(-1.0, 1.0), rng.between(0.0, 1e6)});
  for (int i = 0; i < 144; ++i) matrix.matrix.push_back(i % 13 == 0 ? 0 : rng.between(0.0, 10.0));
  for (const TsplibInstance& instance : {points, matrix}) {
    const TsplibInstance again = read_tsplib(write_tsplib(instance), "again");
    EXPECT_EQ(again.name, instance.name);
    EXPECT_EQ(again.symmetric, instance.symmetric);
    EXPECT_EQ(again.weights, instance.weights);
    EXPECT_EQ(again.points, instance.points);
    EXPECT_EQ(again.matrix, instance.matrix);
  }
  const std::vector<std::size_t> order{0, 2, 1, 3};
  EXPECT_EQ(read_tsplib_tour(write_tsplib_tour("t", order), "t"), order);
}

void expect_refused(const std::string& text, const std::string& words) {
  EXPECT_THAT([&] { read_tsplib(text, "x.tsp"); }, ThrowsMessage<std::invalid_argument>(HasSubstr(words))) << text;
}

TEST(Tsplib, HostileFilesAreOneSentence) {
  expect_refused("", "x.tsp has no EDGE_WEIGHT_TYPE");
  expect_refused("TYPE: CVRP\n", "x.tsp:1: TYPE is 'CVRP', expected TSP, ATSP or SOP");
  expect_refused("NAME: a\nDIMENSION: -3\n", "x.tsp:2: DIMENSION is '-3'");
  expect_refused("DIMENSION: 99999999999\n", "expected a number from 1 to 1000000");
  expect_refused("EDGE_WEIGHT_TYPE: XRAY1\n", "EDGE_WEIGHT_TYPE is 'XRAY1', expected EUC_2D, CEIL_2D or EXPLICIT");
  expect_refused("EDGE_WEIGHT_FORMAT: UPPER_ROW\n", "EDGE_WEIGHT_FORMAT is 'UPPER_ROW', expected FULL_MATRIX");
  expect_refused("CAPACITY: 3\n", "x.tsp:1: 'CAPACITY' is not a keyword that can be read");
  expect_refused("NODE_COORD_SECTION\n1 0 0\n", "expected DIMENSION first");
  expect_refused("DIMENSION: 2\nNODE_COORD_SECTION\n1 0 0\n1 1 1\n", "x.tsp:4: node 1 has two positions");
  expect_refused("DIMENSION: 2\nNODE_COORD_SECTION\n1 0 0\n3 1 1\n",
                 "x.tsp:4: node '3', expected a number from 1 to 2");
  expect_refused("DIMENSION: 2\nNODE_COORD_SECTION\n1 0 zero\n", "x.tsp:3: a coordinate is 'zero'");
  expect_refused("DIMENSION: 2\nEDGE_WEIGHT_SECTION\n0 1\n2\n", "an edge weight is '', expected a number");
  expect_refused("TYPE: TSP\nDIMENSION: 2\nEDGE_WEIGHT_SECTION\n0 1\n2 0\n", "the weight from 1 to 2 is 1 and back 2");
  expect_refused("DIMENSION: 2\nEDGE_WEIGHT_TYPE: EUC_2D\n", "x.tsp has no NODE_COORD_SECTION");
  expect_refused("TYPE: SOP\nDIMENSION: 2\nEDGE_WEIGHT_SECTION\n2\n0 -1\n-1 0\n", "node 2 comes before node 1");
  expect_refused("DIMENSION: 20000\nEDGE_WEIGHT_SECTION\n", "expected at most 10000");
  const auto refuse_tour = [](const std::string& text, const std::string& words) {
    EXPECT_THAT([&] { read_tsplib_tour(text, "x.tour"); }, ThrowsMessage<std::invalid_argument>(HasSubstr(words)));
  };
  refuse_tour("DIMENSION: 2\n", "x.tour has no TOUR_SECTION");
  refuse_tour("DIMENSION: 2\nTOUR_SECTION\n1\n1\n-1\n", "x.tour:4: node 1 comes twice");
  refuse_tour("DIMENSION: 2\nTOUR_SECTION\n1\n-1\n", "x.tour:4: node '-1', expected a number from 1 to 2");
  refuse_tour("DIMENSION: 1\nTOUR_SECTION\n1\n7\n", "'7' follows the 1 nodes");
}

// A path from node 1 to node 4, in which node 3 comes before node 2.
constexpr const char* kSop =
    "NAME: s\nTYPE: SOP\nDIMENSION: 4\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: FULL_MATRIX\n"
    "EDGE_WEIGHT_SECTION\n4\n0 1 5 1000\n-1 0 -1 2\n-1 3 0 9\n-1 -1 -1 0\nEOF\n";

TEST(Tsplib, SequentialOrdering) {
  const TsplibInstance instance = read_tsplib(kSop, "s.sop");
  EXPECT_TRUE(instance.sequential);
  EXPECT_EQ(read_tsplib(write_tsplib(instance), "again").matrix, instance.matrix);
  const auto cost = instance.cost();
  TourProblem problem(*cost, instance.size());
  instance.require_order(problem);
  Context context;
  const Tour tour = solve_tour(problem, context);
  std::vector<std::size_t> order;
  for (const TourStop& stop : tour) order.push_back(stop.element);
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 2, 1, 3}));
  EXPECT_EQ(problem.cost(tour), 5 + 3 + 2);
}

/// Random weights and precedence that some hidden order keeps: the least cost over all orders that keep it, by trying
/// them.
TEST(Tsplib, SequentialOrderingIsOptimalAndKept) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Rng rng(seed);
    const std::size_t n = 7;
    TsplibInstance instance{.symmetric = false, .sequential = true, .weights = TsplibInstance::Weights::full_matrix};
    instance.dimension = n;
    std::vector<std::size_t> hidden{1, 2, 3, 4, 5};
    rng.shuffle(hidden);
    for (std::size_t i = 0; i < n * n; ++i) instance.matrix.push_back(static_cast<double>(rng.below(100)));
    for (std::size_t i = 1; i < n; ++i) instance.matrix[i * n] = -1;
    for (std::size_t j = 0; j + 1 < n; ++j) instance.matrix[(n - 1) * n + j] = -1;
    for (std::size_t a = 0; a < 5; ++a)
      for (std::size_t b = a + 1; b < 5; ++b)
        if (rng.chance(0.4)) instance.matrix[hidden[b] * n + hidden[a]] = -1;
    const auto cost = instance.cost();
    TourProblem problem(*cost, n);
    instance.require_order(problem);
    Context context;
    const Tour tour = solve_tour(problem, context);
    const auto price = [&](const std::vector<std::size_t>& order) {
      double sum = 0;
      for (std::size_t k = 1; k < n; ++k) {
        for (std::size_t later = k; later < n; ++later)
          if (instance.matrix[order[k - 1] * n + order[later]] == -1) return 1e18;
        sum += instance.matrix[order[k - 1] * n + order[k]];
      }
      return sum;
    };
    std::vector<std::size_t> order{0, 1, 2, 3, 4, 5, 6}, driven;
    double best = 1e18;
    do best = std::min(best, price(order));
    while (std::next_permutation(order.begin() + 1, order.end() - 1));
    for (const TourStop& stop : tour) driven.push_back(stop.element);
    ASSERT_EQ(driven.back(), n - 1);
    ASSERT_EQ(price(driven), best) << seed;
  }
}

ShapeTourModel drawing_of(std::uint64_t seed) {
  Rng rng(seed);
  return ShapeTourModel(random_drawing({.lines = true, .polygons = true}, 8, rng));
}

// A stand-in that reads what LKH would read and answers with the nodes as they are numbered.
TEST(Lkh, IsGivenAProblemAndItsTourIsReadBack) {
  const TemporaryFolder folder;
  const std::string program = folder.file("LKH");
  write_file(program,
             "#!/bin/sh\n"
             "problem=$(sed -n 's/^PROBLEM_FILE = //p' \"$1\")\ntour=$(sed -n 's/^TOUR_FILE = //p' \"$1\")\n"
             "n=$(sed -n 's/^DIMENSION: //p' \"$problem\")\n"
             "{ echo \"DIMENSION: $n\"; echo TOUR_SECTION; i=1; while [ $i -le $n ]; do echo $i; i=$((i+1)); done; "
             "echo -1; } > \"$tour\"\n");
  ::chmod(program.c_str(), 0700);
  const ShapeTourModel model = drawing_of(1);
  Context context(1, 60);
  const Tour tour = lkh_tour(model.problem(), program, context);
  ASSERT_EQ(tour.size(), model.problem().elements());
  for (std::size_t i = 0; i < tour.size(); ++i) EXPECT_EQ(tour[i], (TourStop{i, 0}));
}

TEST(Lkh, FailuresAreOneSentence) {
  const ShapeTourModel model = drawing_of(1);
  Context context(1, 60);
  EXPECT_THAT([&] { lkh_tour(model.problem(), "/no/such/LKH", context); },
              ThrowsMessage<std::runtime_error>(HasSubstr("cannot run '/no/such/LKH'")));
  EXPECT_THAT([&] { lkh_tour(model.problem(), "/bin/true", context); },
              ThrowsMessage<std::runtime_error>(HasSubstr("'/bin/true' has left no tour")));
}

TEST(Lkh, IsOptimalOnSmallDrawings) {
  const auto program = find_lkh();
  if (!program) GTEST_SKIP() << "LKH is not on the PATH";
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const ShapeTourModel model = drawing_of(seed);
    Context context(1, 60);
    const double cost = model.problem().cost(lkh_tour(model.problem(), *program, context));
    EXPECT_NEAR(cost, model.problem().cost(exact_tour(model.problem())), 1e-3 * cost);
  }
}

}  // namespace
}  // namespace oxturn
