#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algorithms/improve/completion.hpp"
#include "algorithms/improve/detours.hpp"
#include "algorithms/improve/improve.hpp"
#include "algorithms/improve/witnesses.hpp"
#include "coverage_oracle.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/swath.hpp"
#include "maps/generators.hpp"
#include "tests/support/planners.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

// A path of so many segments that only some cells are looked at; the truth is the distance of points from it.
TEST(Completion, SeesWhatAPathOfManySegmentsLeaves) {
  const double width = 0.4;
  const Problem problem({"hall", box_region({0, 0}, {8, 5}), "test", "test"}, disc(0.1, width));
  const Completion completion(problem, 0.99);
  const EdgeIndex target(completion.target());
  for (const auto seed : seeds(3)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Polyline line;
    for (int k = 0; k <= 12; ++k)
      for (int i = 0; i <= 250; ++i) {
        const double x = 0.2 + 7.6 * (k % 2 == 0 ? i : 250 - i) / 250;
        line.emplace_back(x, 0.11 + 0.385 * k + rng.between(0.0, 0.02));
      }
    const EdgeIndex left(completion.uncovered(line));
    int uncovered = 0;
    for (int k = 0; k < 4000; ++k) {
      const Point p(rng.between(0.0, 8.0), rng.between(0.0, 5.0));
      double nearest = 1e9;
      for (std::size_t i = 1; i < line.size(); ++i)
        nearest = std::min(nearest, distance_to_segment(p, line[i - 1], line[i]));
      if (nearest > width / 2 + 1e-6 && target.contains(p)) {
        ++uncovered;
        EXPECT_TRUE(left.contains(p)) << p.transpose();
      }
      if (nearest < width / 2 - 2 * Completion::kChord * width) { EXPECT_FALSE(left.contains(p)) << p.transpose(); }
    }
    EXPECT_GT(uncovered, 0);
  }
}

// What a path with detours leaves uncovered is found from the detours alone: nothing is lost where they cut off a turn.
TEST(Detours, AreAllThatAPathWithDetoursCoversBesides) {
  const double width = 0.4;
  std::size_t detours = 0;
  for (const char* kind : {"rooms", "cave", "clutter", "polygon"})
    for (const char* planner : {"connected-fermat", "contour"}) {
      SCOPED_TRACE(fmt::format("{} {}", kind, planner));
      const Problem problem(generate(kind, {}, 11), disc(0.2, width));
      const Polyline path = vertices_of(plan(planner, problem, {{"repair", false}}), problem.start());
      const Completion completion(problem, 1);
      const Region left = completion.uncovered(path);
      std::vector<ToCover> pieces;
      for (const Polygon& piece : left.polygons) pieces.push_back({piece, {piece}});
      const WithDetours longer =
          with_detours(path, pieces, 1e9, 1e9, 0.499 * width, Connector(problem), problem.walls());
      detours += longer.detours.size();
      const Region found =
          subtract(left, swath_parts(longer.detours, width / 2, Completion::kChord * width, Bound::inside));
      const Region truth = completion.uncovered(longer.path);
      EXPECT_LT(area(found), area(left));
      EXPECT_NEAR(area(found), area(truth), 1e-6 * area(problem.target()));
      EXPECT_LT(area(subtract(found, truth)), 1e-6 * area(problem.target()));
    }
  EXPECT_GT(detours, 500u);
}

TEST(Improved, TheMovesByDefaultGrowWithTheTargetUpToALimit) {
  const auto moves = [](double side) {  // tool widths
    const Problem problem({"hall", box_region({0, 0}, {side, side}), "test", "test"}, disc(0.1, 1));
    return moves_in_all({}, problem);
  };
  EXPECT_NEAR(moves(20), 4000 * 400, 8000);
  EXPECT_EQ(moves(60), 2e6);
  EXPECT_EQ(moves(1000), 2e6);
}

// Where all is to be covered, a few moves for each square gain nothing: the best start is the result, completed, or as
// it is where all starts are complete already.
TEST(Improved, FewMovesAreNotMadeWhereAllIsToBeCovered) {
  const Problem problem(generate("rooms", {}, 3), disc(0.2, 0.4));
  const Completion completion(problem, 1);
  std::vector<PathToImprove> starts;
  double shortest = 1e9, uncompleted = 1e9;
  for (const char* planner : {"boustrophedon", "contour"}) {
    starts.push_back({plan(planner, problem)});
    uncompleted = std::min(uncompleted, starts.back().path.length());
    const Polyline points = vertices_of(starts.back().path, problem.start());
    Context context;
    shortest = std::min(shortest, length(completion.completed(points, completion.uncovered(points), context)));
  }
  const double squares = area(problem.target()) / (0.4 * 0.4);
  const auto with = [&](double coverage, double each) {
    double made = -1;
    Context::Sinks sinks;
    sinks.record = [&](const std::string& name, double value) {
      if (name == "annealing_moves") made = value;
    };
    Context context(1, 1e9, sinks);
    const int moves = static_cast<int>(each * squares);
    const Path path = improved(problem, starts, {.coverage = coverage, .moves = moves}, context);
    return std::pair(made, path.length());
  };
  const auto expect_unmoved = [&](double length) {
    const auto [made, result] = with(1, 9);
    EXPECT_EQ(made, 0);
    EXPECT_DOUBLE_EQ(result, length);
  };
  expect_unmoved(shortest);
  // Both, however few.
  EXPECT_DOUBLE_EQ(plan("shortest", problem, {{"moves", std::int64_t{1}}}).length(), uncompleted);
  starts.front().complete = true;
  expect_unmoved(shortest);
  starts.back().complete = true;
  expect_unmoved(uncompleted);
  EXPECT_LT(uncompleted, shortest);
  starts.back().complete = false;
  EXPECT_GT(with(1, 100).first, 90 * squares);
  EXPECT_LT(with(1, 100).second, shortest);
  EXPECT_GT(with(0.99, 9).first, 8 * squares);
  EXPECT_LT(with(0.99, 9).second, shortest);
}

std::size_t vertices_in(const Path& path) {
  std::size_t sum = 0;
  for (const Leg& leg : path.legs) sum += leg.points.size();
  return sum;
}

// Time is moves, points of rasters and vertices of measured paths: none grows faster than what it has to.
TEST(Shortest, TheEffortIsBoundedByTheMovesAndTheSizeOfTheProblem) {
  constexpr double kFinest = 120;  // points of the raster in a tool width
  for (const char* kind : {"cave", "spiral", "field"})
    for (const double side : {20.0, 60.0})     // tool widths
      for (const double each : {1.0, 20.0}) {  // moves for each square of the tool's width
        const double radius = 0.2, width = 1.5;
        SCOPED_TRACE(fmt::format("{} of {} tool widths, {} moves each", kind, side, each));
        const Problem problem(
            generate(kind, {{"width", side * width}, {"height", side * width / 4}, {"robot", radius}}, 5),
            disc(radius, width));
        const double squares = area(problem.target()) / (width * width), moves = std::floor(each * squares);
        const Settings settings{{"coverage", 0.9999}, {"moves", static_cast<std::int64_t>(moves)}};
        const RecordedPlan result = plan_recorded("shortest", problem, settings);
        double vertices = static_cast<double>(vertices_in(result.path));
        for (const char* start : {"boustrophedon", "contour"})
          vertices = std::max(vertices, static_cast<double>(vertices_in(plan(start, problem))));
        const Point size = bounding_box(Witnesses::turned(problem.target())).size();
        const double raster = size.prod() * std::pow(kFinest / width, 2);
        EXPECT_LE(result.figures.at("annealing_moves"), 1.3 * moves + 1000);  // windows are drawn by lot
        EXPECT_LE(result.figures.at("raster_points"), 4000 * moves + 0.75 * raster);
        EXPECT_LE(result.figures.at("measured_vertices"), moves / 15 + 4 * vertices);
      }
}

TEST(Shortest, ItBeginsHotterWhereThereAreMoreMovesForTheSize) {
  const Problem problem({"room", box_region({0, 0}, {1.6, 1.2}), "test", "test"}, disc(0.2, 0.4));
  const double squares = area(problem.target()) / (0.4 * 0.4);
  for (const auto& [each, temperature] : {std::pair(200.0, 0.006), std::pair(1000.0, 0.01), std::pair(11000.0, 0.05)}) {
    const Settings by_moves{{"coverage", 0.99}, {"moves", static_cast<std::int64_t>(each * squares)}};
    Settings named = by_moves;
    named["temperature"] = temperature;
    EXPECT_EQ(vertices_of(plan("shortest", problem, by_moves), problem.start()),
              vertices_of(plan("shortest", problem, named), problem.start()));
    named["temperature"] = 0.02;
    EXPECT_NE(vertices_of(plan("shortest", problem, by_moves), problem.start()),
              vertices_of(plan("shortest", problem, named), problem.start()));
  }
}

}  // namespace
}  // namespace oxturn
