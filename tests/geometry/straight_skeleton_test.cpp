#include "geometry/mesh/straight_skeleton.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/create_straight_skeleton_from_polygon_with_holes_2.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"
#include "random_region.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

constexpr double kRounding = 1e-6;  // nearly parallel edges of round vertices meet far off

using Nodes = std::vector<std::array<double, 3>>;  // time, x, y

/// CGAL's own builder, which tests all pairs of vertices and edges.
Nodes nodes_by_cgal(const Polygon& polygon) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto ring = [](const Ring& r) {
    CGAL::Polygon_2<Kernel> out;
    for (const Point& p : r) out.push_back({p.x(), p.y()});
    return out;
  };
  CGAL::Polygon_with_holes_2<Kernel> shape(ring(polygon.outer));
  for (const Ring& hole : polygon.holes) shape.add_hole(ring(hole));
  const auto skeleton = CGAL::create_interior_straight_skeleton_2(shape, Kernel());
  Nodes nodes;
  for (auto v = skeleton->vertices_begin(); v != skeleton->vertices_end(); ++v)
    nodes.push_back({v->time(), v->point().x(), v->point().y()});
  return nodes;
}

/// Every node is one of the others, but for rounding.
void expect_among(const Nodes& nodes, const Nodes& others) {
  for (const auto& n : nodes)
    EXPECT_TRUE(std::ranges::any_of(others,
                                    [&](const auto& o) {
                                      return std::abs(n[0] - o[0]) < kRounding &&
                                             std::hypot(n[1] - o[1], n[2] - o[2]) < kRounding;
                                    }))
        << "time " << n[0] << " at (" << n[1] << ", " << n[2] << ")";
}

void expect_same(const Region& region) {
  for (const Polygon& polygon : region.polygons) {
    Nodes nodes;
    for (const StraightSkeleton::Node& n : straight_skeleton(polygon).nodes)
      nodes.push_back({n.time, n.at.x(), n.at.y()});
    const Nodes expected = nodes_by_cgal(polygon);
    EXPECT_EQ(nodes.size(), expected.size());
    expect_among(nodes, expected);
    expect_among(expected, nodes);
  }
}

// Needles and wedges: reflex vertices that are many times faster than edges.
TEST(StraightSkeleton, OfStarsIsThatOfAllPairs) {
  for (const auto seed : seeds(20)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    expect_same(star_region(rng, 8 + static_cast<int>(seed % 5) * 15));
  }
}

TEST(StraightSkeleton, AmongObstaclesIsThatOfAllPairs) {
  for (const auto seed : seeds(10)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Region clutter = clutter_box(rng, 4, 2, seed % 3 == 0);
    expect_same(clutter);
    expect_same(erode(clutter, 0.04, 1e-3, Bound::inside));  // round vertices, and parts of their own
  }
}

Polygon between_squares(Rng& rng) {
  Region region = box_region({0, 0}, {12, 12});
  for (double x = 1; x < 12; x += 2)
    for (double y = 1; y < 12; y += 2) {
      const Point size(1, 0.5 * rng.between(1, 2));
      if (rng.chance(0.7)) region = subtract(region, box_region({x, y}, Point(x, y) + size));
    }
  return region.polygons[0];
}

// Parallel edges, in which many events have exactly the same time, at the same point and elsewhere.
TEST(StraightSkeleton, BetweenSquaresIsThatOfAllPairs) {
  for (const auto seed : seeds(10)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    expect_same({{between_squares(rng)}});
  }
}

// Memory with gaps, so that what is made later does not lie at higher addresses.
TEST(StraightSkeleton, DoesNotDependOnAddresses) {
  for (const auto seed : seeds(5)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Polygon polygon = between_squares(rng);
    const StraightSkeleton first = straight_skeleton(polygon);
    std::vector<std::vector<char>> blocks(50'000);
    for (std::vector<char>& block : blocks) block.resize(static_cast<std::size_t>(rng.between(8, 300)));
    rng.shuffle(blocks);
    blocks.resize(blocks.size() / 2);
    const StraightSkeleton second = straight_skeleton(polygon);
    const auto arc = [](const StraightSkeleton::Arc& a) { return std::tuple(a.low, a.high, a.faces[0], a.faces[1]); };
    EXPECT_TRUE(std::ranges::equal(first.arcs, second.arcs, {}, arc, arc));
    const auto node = [](const StraightSkeleton::Node& n) { return std::tuple(n.time, n.at.x(), n.at.y()); };
    EXPECT_TRUE(std::ranges::equal(first.nodes, second.nodes, {}, node, node));
  }
}

}  // namespace
}  // namespace oxturn
