#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "algorithms/improve/completion.hpp"
#include "algorithms/improve/witnesses.hpp"
#include "coverage_oracle.hpp"
#include "geometry/edge_index.hpp"
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
