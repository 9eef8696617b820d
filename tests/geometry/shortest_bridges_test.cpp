#include "geometry/mesh/shortest_bridges.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/disjoint_sets.hpp"
#include "base/random.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/mesh/medial_axis.hpp"
#include "geometry/overlay/cut_along.hpp"
#include "random_region.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

double sum_of(const std::vector<Polyline>& lines) {
  double sum = 0;
  for (const Polyline& line : lines) sum += length(line);
  return sum;
}

std::vector<Ring> rings_of(const Region& region) {
  std::vector<Ring> rings;
  for_each_ring(region, [&](const Ring& ring) { rings.push_back(ring); });
  return rings;
}

double between(const Ring& a, const Ring& b) {
  double far = 1e300;
  for_each_edge(a, [&](const Point& p, const Point& q) {
    for_each_edge(b, [&](const Point& r, const Point& s) {
      far = std::min({far, distance_to_segment(p, r, s), distance_to_segment(r, p, q)});
    });
  });
  return far;
}

// Oracle: Kruskal over the distances of all pairs.
double least_tree(const std::vector<Ring>& rings) {
  struct Pair {
    double far;
    std::size_t a, b;
  };
  std::vector<Pair> pairs;
  for (std::size_t a = 0; a < rings.size(); ++a)
    for (std::size_t b = a + 1; b < rings.size(); ++b) pairs.push_back({between(rings[a], rings[b]), a, b});
  std::sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.far < b.far; });
  DisjointSets sets(rings.size());
  double least = 0;
  for (const Pair& p : pairs)
    if (sets.unite(p.a, p.b)) least += p.far;
  return least;
}

void expect_tree(const Region& region) {
  const std::vector<Ring> rings = rings_of(region);
  const std::vector<Polyline> bridges = shortest_bridges(region);
  EXPECT_NEAR(sum_of(bridges), least_tree(rings), 1e-9 * static_cast<double>(rings.size()));
  EXPECT_EQ(bridges.size() + 1, rings.size());
  EXPECT_TRUE(std::ranges::is_sorted(bridges, {}, [](const Polyline& line) { return length(line); }));
  const EdgeIndex walls(region);
  for (const Polyline& line : bridges) {  // where rings touch, a bridge is a point on both but for rounding
    const Point middle = (line[0] + line[1]) / 2;
    EXPECT_TRUE(contains(region, middle) || walls.nearest(middle)->distance < 1e-12) << length(line);
  }
  EXPECT_EQ(hole_count(cut_along(region, bridges, 1e-4)), 0u);
}

TEST(ShortestBridges, AreAMinimumSpanningTree) {
  for (const auto seed : seeds(10)) {
    SCOPED_TRACE(seed);
    expect_tree(generate("clutter", {{"width", 9.0}, {"height", 8.0}}, seed).free);
    expect_tree(generate("speckle", {{"width", 6.0}, {"height", 5.0}}, seed).free);
    Rng rng(seed);
    for (const bool on_grid : {false, true}) expect_tree(clutter_box(rng, 7, 5, on_grid));
  }
}

// Small rings close together and far from the others, and one large one about all: the distances of neighbours differ
// by a factor of thousands.
TEST(ShortestBridges, OfCrowdsFarApart) {
  for (const auto seed : seeds(10)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    Region region = box_region({0, 0}, {1000, 700});
    for (const Point& crowd : {Point(20, 30), Point(500, 350), Point(960, 600)})
      for (int k = 0; k < 25; ++k) {
        const Point at = crowd + 0.1 * Point(k % 5, k / 5);
        Ring hole = convex_ring(rng, at, rng.between(0.01, 0.045), rng.between(3, 8));
        std::ranges::reverse(hole);
        region.polygons[0].holes.push_back(hole);
      }
    std::vector<Ring> rings = rings_of(region);
    EXPECT_NEAR(sum_of(shortest_bridges(region)), least_tree(rings), 1e-6);
  }
}

TEST(ShortestBridges, StayInTheirPolygons) {
  const auto square = [](double x, double side) { return box_region({x, 0}, {x + side, side}).polygons[0].outer; };
  Polygon left{square(0, 4), {}}, right{square(4.1, 4), {}};
  for (const double x : {1.0, 5.0, 6.5}) {
    Ring hole = square(x, 1);
    for (Point& p : hole) p.y() += 1.5;
    std::ranges::reverse(hole);
    (x < 4 ? left : right).holes.push_back(hole);
  }
  const std::vector<Polyline> bridges = shortest_bridges({{left, right}});
  EXPECT_EQ(bridges.size(), 3u);
  EXPECT_NEAR(sum_of(bridges), 1 + 0.5 + 0.6, 1e-6);
}

TEST(ShortestBridges, OfRingsThatTouchHaveNoLength) {
  Region region = box_region({0, 0}, {4, 4});
  region.polygons[0].holes.push_back({{0, 2}, {1, 3}, {2, 2}, {1, 1}});
  const std::vector<Polyline> bridges = shortest_bridges(region);
  ASSERT_EQ(bridges.size(), 1u);
  EXPECT_EQ(length(bridges[0]), 0);
  EXPECT_TRUE(shortest_bridges({}).empty());
  EXPECT_TRUE(shortest_bridges(box_region({0, 0}, {4, 4})).empty());
}

// The search along the axis shares no code with the other one.
TEST(ShortestBridges, AreThoseOfTheMedialAxis) {
  for (const auto seed : seeds(5)) {
    SCOPED_TRACE(seed);
    const Region region = generate("clutter", {{"width", 20.0}, {"height", 15.0}}, seed).free;
    EXPECT_NEAR(sum_of(shortest_bridges(region)), sum_of(bridges_between_rings(region).tree), 1e-4);
  }
}

}  // namespace
}  // namespace oxturn
