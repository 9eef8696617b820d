// Diagonals and straight segments of a lattice, against the exact answers of the edge index.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "algorithms/lattice/grid_graph.hpp"
#include "geometry/edge_index.hpp"
#include "maps/generators.hpp"
#include "tests/support/maps.hpp"

namespace oxturn {
namespace {

TEST(GridGraph, DiagonalsAndStraightSegmentsAgreeWithTheEdgeIndex) {
  int diagonals = 0, straight = 0, blocked = 0;
  for (const char* generator : {"polygon", "clutter", "rooms", "cave"})
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      SCOPED_TRACE(fmt::format("{} --seed {}", generator, seed));
      const Problem problem(generate(generator, {}, seed), Robot{});
      const Region& space = problem.configuration_space();
      GridGraph graph = make_grid_graph_at(space, "test", problem.start(), 0.3, seed % 2 ? 0.0 : 0.4);
      graph.add_diagonals(space);
      for (int j = 0; j + 1 < graph.rows(); ++j)
        for (int i = 0; i + 1 < graph.columns(); ++i)
          for (const int d : {0, 1}) {
            const bool free = problem.walls().contains(graph.centre(i + d, j), graph.centre(i + 1 - d, j + 1));
            ASSERT_EQ(graph.diagonal(i + d, j, 1 - 2 * d, 1), free) << i << " " << j << " " << d;
            ASSERT_EQ(graph.diagonal(i + 1 - d, j + 1, 2 * d - 1, -1), free);
            diagonals += free;
          }
      Rng rng(seed);
      for (int k = 0; k < 4000; ++k) {
        const int i = rng.between(0, graph.columns() - 1), j = rng.between(0, graph.rows() - 1);
        const int i2 = i + rng.between(-6, 6), j2 = j + rng.between(-6, 6);
        const bool found = graph.straight({i, j}, {i2, j2});
        ASSERT_EQ(graph.straight({i2, j2}, {i, j}), found);
        const bool free = problem.walls().contains(graph.centre(i, j), graph.centre(i2, j2));
        if (found) { ASSERT_TRUE(free) << i << " " << j << " to " << i2 << " " << j2; }
        straight += found;
        blocked += free && !found;
      }
    }
  EXPECT_GT(diagonals, 10000);
  EXPECT_GT(straight, 5000);
  EXPECT_LT(blocked, straight / 4);  // only where a wall enters a square that the segment meets
}

}  // namespace
}  // namespace oxturn
