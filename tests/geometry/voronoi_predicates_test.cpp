#include "geometry/mesh/voronoi_predicates.hpp"

#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

#include "base/random.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

using Segments = std::vector<std::array<int, 4>>;  // x and y of both ends

/// Vertices less edges plus faces, with the vertex at infinity. 2, as of every connected planar graph, unless the
/// diagram is wrong.
long euler_number(const Segments& segments) {
  boost::polygon::voronoi_builder<std::int32_t, VoronoiNumbers, VoronoiPredicates> builder;
  for (const auto& [ax, ay, bx, by] : segments) builder.insert_segment(ax, ay, bx, by);
  boost::polygon::voronoi_diagram<double> diagram;
  builder.construct(&diagram);
  return static_cast<long>(diagram.num_vertices() + 1 + diagram.num_cells()) -
         static_cast<long>(diagram.num_edges() / 2);
}

/// By quarter turns: the sweep meets the segments from each side.
Segments turned(Segments segments, int quarters) {
  for (auto& [ax, ay, bx, by] : segments)
    for (int k = 0; k < quarters; ++k) {
      ax = -std::exchange(ay, ax);
      bx = -std::exchange(by, bx);
    }
  return segments;
}

// Two vertical edges that face each other and end a quantum apart: a vertex was built beyond the second one, and in
// large maps whole areas of the diagram were lost.
TEST(VoronoiPredicates, FacingEdgesThatEndAQuantumApart) {
  const Segments segments{{-368975033, -110765466, -368975033, -109821382},
                          {-365346935, -109677037, -365346935, -110765467},
                          {-365346935, -110765467, -365273898, -110941786}};
  for (int quarters = 0; quarters < 4; ++quarters) EXPECT_EQ(euler_number(turned(segments, quarters)), 2) << quarters;
}

// Walls along the axes in pairs, where rounding moves vertices by a quantum.
TEST(VoronoiPredicates, PairsOfWallsThatAlmostEndTogether) {
  constexpr int kSpacing = 1 << 22, kFar = -360'000'000;
  for (const auto seed : seeds(200)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Segments segments;
    for (int i = 0; i < 64; ++i) {
      const int x = kFar + (i % 8) * kSpacing + rng.between(0, kSpacing / 4);
      const int y = kFar + (i / 8) * kSpacing + rng.between(0, kSpacing / 4);
      const int length = rng.between(1, kSpacing / 4), apart = rng.between(kSpacing / 4, kSpacing / 2);
      for (const int from : {x, x + apart})
        segments.push_back({from, y + rng.between(-1, 1), from, y + length + rng.between(0, kSpacing / 4)});
    }
    for (int quarters = 0; quarters < 4; ++quarters) EXPECT_EQ(euler_number(turned(segments, quarters)), 2) << quarters;
  }
}

}  // namespace
}  // namespace oxturn
