#include "geometry/mesh/medial_axis.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/disjoint_sets.hpp"
#include "base/random.hpp"
#include "geometry/overlay/cut_along.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

double to_boundary(const Region& region, const Point& p) {
  double least = 1e300;
  for_each_edge(region, [&](const Point& a, const Point& b) { least = std::min(least, distance_to_segment(p, a, b)); });
  return least;
}

double length_of(const MedialAxis& axis) {
  double sum = 0;
  for (const MedialAxis::Edge& e : axis.edges) sum += distance(axis.nodes[e.a].at, axis.nodes[e.b].at);
  return sum;
}

// By hand: a ridge of 6 m and four edges to the vertices, sqrt(8) each.
TEST(MedialAxis, OfARectangle) {
  const MedialAxis axis = medial_axis(box_region({0, 0}, {10, 4}), 0.01);
  EXPECT_EQ(axis.nodes.size(), 6u);
  EXPECT_NEAR(length_of(axis), 6 + 4 * std::sqrt(8), 1e-6);
  EXPECT_EQ(axis.spokes.size(), 4u + 2 * 3);  // each end of the ridge has three nearest points
}

// Brute force: what is nearest to a node, and that each node has two nearest points.
TEST(MedialAxis, NodesAreAsFarFromTheirFeetAsFromTheBoundary) {
  for (const auto seed : seeds(10))
    for (const char* family : {"polygon", "clutter"}) {
      SCOPED_TRACE(std::string(family) + " " + std::to_string(seed));
      const Region region = generate(family, {{"width", 9.0}, {"height", 8.0}}, seed).free;
      const MedialAxis axis = medial_axis(region, 0.01);
      for (const MedialAxis::Spoke& s : axis.spokes) {
        const MedialAxis::Node& n = axis.nodes[s.node];
        ASSERT_NEAR(distance(n.at, s.foot), to_boundary(region, n.at), 1e-6);
        ASSERT_NEAR(n.clearance, to_boundary(region, n.at), 1e-6);
        ASSERT_NEAR(to_boundary(region, s.foot), 0, 1e-6);
      }
      // One component; as many cycles as holes, because each hole lies in one.
      DisjointSets sets(axis.nodes.size());
      std::size_t cycles = 0, parts = axis.nodes.size();
      for (const MedialAxis::Edge& e : axis.edges) sets.unite(e.a, e.b) ? --parts : ++cycles;
      EXPECT_EQ(parts, 1u);
      EXPECT_EQ(cycles, hole_count(region));
    }
}

// Two halls side by side: circles touch the wall between them, which begins near the lattice's origin.
TEST(MedialAxis, AWallInTheMiddleIsSeenFromBothSides) {
  for (const auto seed : seeds(300)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const double w = rng.between(5.0, 500.0), h = rng.between(5.0, 500.0), x = w * rng.between(0.49, 0.51),
                 wall = rng.between(0.01, 1.0), gap = rng.between(0.3, 3.0), right = h * rng.between(0.5, 1.0);
    Ring ring{{0, 0},
              {w, 0},
              {w, right},
              {x + wall, right},
              {x + wall, gap},
              {x + 0.8 * wall, 0.8 * gap},
              {x + 0.2 * wall, 0.8 * gap},
              {x, gap},
              {x, h},
              {0, h}};
    if (rng.chance(0.5))
      for (Point& p : ring) p = perpendicular(p);
    const Region region{{{ring, {}}}};
    for (const MedialAxis::Node& n : medial_axis(region, 0.001).nodes)
      ASSERT_NEAR(n.clearance, to_boundary(region, n.at), 1e-5);
  }
}

// In the order of the boundary each foot follows the one before: around the polygon once.
TEST(MedialAxis, SpokesFollowTheBoundary) {
  for (const auto seed : seeds(10)) {
    const Region region = generate("polygon", {{"width", 9.0}, {"height", 8.0}}, seed).free;
    const MedialAxis axis = medial_axis(region, 0.01);
    double around = 0;
    for (std::size_t k = 0; k < axis.spokes.size(); ++k)
      around += distance(axis.spokes[k].foot, axis.spokes[(k + 1) % axis.spokes.size()].foot);
    EXPECT_NEAR(around, perimeter(region), 1e-5) << seed;
  }
}

// They stay inside, nothing is nearer to their middle than their ends, no two cross, and the spanning tree is among
// them.
TEST(BridgesBetweenRings, AreFreeAndDoNotCross) {
  for (const auto seed : seeds(5)) {
    SCOPED_TRACE(seed);
    const Region region = generate("clutter", {{"width", 9.0}, {"height", 8.0}}, seed).free;
    const auto [lines, tree] = bridges_between_rings(region);
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const Point middle = (lines[i][0] + lines[i][1]) / 2;
      ASSERT_TRUE(contains(region, middle));
      for_each_edge(region, [&](const Point& a, const Point& b) {
        ASSERT_GE(distance_to_segment(middle, a, b), length(lines[i]) / 2 - 1e-6);
      });
      for (std::size_t j = 0; j < i; ++j) {
        const Point a = lines[i][0], b = lines[i][1], c = lines[j][0], d = lines[j][1];
        ASSERT_FALSE(cross(b - a, c - a) * cross(b - a, d - a) < -1e-9 &&
                     cross(d - c, a - c) * cross(d - c, b - c) < -1e-9);
      }
    }
    for (const Polyline& bridge : tree) EXPECT_NE(std::ranges::find(lines, bridge), lines.end());
  }
}

}  // namespace
}  // namespace oxturn
