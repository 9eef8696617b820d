#include "algorithms/lattice/grid_graph.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "maps/generators.hpp"
#include "tests/support/maps.hpp"

namespace oxturn {
namespace {

TEST(GridGraph, AgreesWithExactSegmentTests) {
  for (const char* generator : {"polygon", "clutter", "cave"})
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      SCOPED_TRACE(fmt::format("{} --seed {}", generator, seed));
      const Problem problem(generate(generator, {}, seed), Robot{});
      Rng rng(seed);
      const double side = rng.between(0.15, 0.5), angle = rng.between(0.0, 1.5);
      const Box box = bounding_box(problem.configuration_space());
      // At a random position and angle no wall lies on a lattice line, so both must agree on every node and edge.
      const Point origin = box.centre() - rotated({20 * side, 20 * side}, angle);
      const GridGraph graph(problem.configuration_space(), side, angle, origin, 40, 40);
      const EdgeIndex& space = problem.walls();
      for (int j = 0; j < 40; ++j)
        for (int i = 0; i < 40; ++i) {
          const Point here = origin + rotated(Point(side * (i + 0.5), side * (j + 0.5)), angle);
          ASSERT_EQ(graph.free(i, j), space.contains(here)) << i << " " << j;
          for (const Direction d : {kEast, kNorth}) {
            if (i + kColumnStep[d] >= 40 || j + kRowStep[d] >= 40) continue;
            const Point there = here + rotated(side * Point(kColumnStep[d], kRowStep[d]), angle);
            ASSERT_EQ(graph.passable(i, j, d), space.contains(here, there)) << i << " " << j << " " << d;
            ASSERT_EQ(graph.passable(i + kColumnStep[d], j + kRowStep[d], opposite(d)), graph.passable(i, j, d));
          }
        }
    }
}

TEST(GridGraph, FirstCentresLieAtTheWall) {
  const Problem problem({"room", box_region({5, 5}, {9, 8}), "test", ""}, Robot{});
  const GridGraph graph = make_grid_graph(problem, {.side = 0.25, .block = 2});
  EXPECT_NEAR(graph.centre(0, 0).x(), 5.2, 1e-5);
  EXPECT_NEAR(graph.centre(0, 0).y(), 5.2, 1e-5);
  EXPECT_TRUE(graph.free(0, 0));
  EXPECT_EQ(graph.columns() % 2, 0);
}

TEST(GridGraph, DominantDirectionOfATurnedRoom) {
  for (const double angle : {0.0, 0.1, 0.7, 1.2})
    EXPECT_NEAR(dominant_direction(transformed(box_region({0, 0}, {4, 2}), angle, {0, 0})), angle, 1e-9);
}

TEST(GridGraph, TooManyCellsIsOneSentence) {
  const Problem problem({"hall", box_region({0, 0}, {1000, 1000}), "test", ""}, Robot{});
  EXPECT_THROW(make_grid_graph(problem, {.side = 1e-3, .block = 2}), std::invalid_argument);
}

}  // namespace
}  // namespace oxturn
