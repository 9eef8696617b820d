#include "geometry/coarse_arcs.hpp"

#include <gtest/gtest.h>

#include "geometry/edge_index.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/overlay/swath.hpp"
#include "geometry/overlay/validity.hpp"
#include "geometry/raster.hpp"
#include "tests/geometry/samples.hpp"

namespace oxturn {
namespace {

Region space_of(const Region& free, double radius) { return erode(free, radius, 0.002 * radius, Bound::inside); }

/// What a disc of radius `reach` covers from the boundary of a region.
Region covered_from_boundary(const Region& region, double reach) {
  std::vector<Polyline> rings;
  for_each_ring(region, [&](const Ring& ring) {
    rings.push_back(ring);
    rings.back().push_back(ring.front());
  });
  return swath(rings, reach, 1e-5 * reach, Bound::inside);
}

void expect_promises(const Region& old, double tolerance, double reach) {
  const Region now = with_coarser_arcs(old, tolerance, reach);
  EXPECT_FALSE(find_flaw(now));
  const EdgeIndex walls(old);
  for_each_edge(now, [&](const Point& a, const Point& b) { EXPECT_TRUE(walls.contains(a, b)) << a.transpose(); });
  ASSERT_EQ(hole_count(now), hole_count(old));
  for_each_ring(now, [&](const Ring& ring) {
    for (const Point& p : ring) EXPECT_LE(samples::distance_to_boundary(old, p), tolerance + 1e-9) << p.transpose();
  });
}

TEST(CoarserArcs, KeepTheirPromises) {
  Rng rng(5);
  for (int round = 0; round < 30; ++round) {
    SCOPED_TRACE(round);
    const double radius = rng.between(0.02, 0.3), tolerance = radius * rng.between(0.001, 0.3);
    for (const Region& free : {samples::holed_star(rng, {0, 0}, 2), trace(samples::speckled(rng, 60, 0.05, 40, 8))}) {
      const Region old = space_of(free, radius);
      expect_promises(old, tolerance, radius);
      expect_promises(old, tolerance, std::numeric_limits<double>::infinity());
    }
  }
}

TEST(CoarserArcs, AKeptPointStaysInside) {
  const Region old = space_of({{{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {{{4, 4}, {4, 6}, {6, 6}, {6, 4}}}}}}, 1);
  const Ring& around = old.polygons.front().holes.front();
  std::size_t cut_off = 0;
  for (const Point& p : around) {
    if (!EdgeIndex(with_coarser_arcs(old, 0.02, 1)).contains(p)) ++cut_off;
    const Region now = with_coarser_arcs(old, 0.02, 1, p);
    EXPECT_TRUE(EdgeIndex(now).contains(p));
    EXPECT_LT(now.polygons.front().holes.front().size(), around.size());  // elsewhere arcs are coarser
  }
  EXPECT_GT(cut_off, 0u);
}

/// The robot's tool is as wide as the robot: what it covers behind the boundary is the same.
TEST(CoarserArcs, CoverTheSame) {
  Rng rng(6);
  for (int round = 0; round < 10; ++round) {
    SCOPED_TRACE(round);
    const double radius = rng.between(0.05, 0.3), reach = radius * rng.between(0.5, 2.0);
    const Region old = space_of(samples::holed_star(rng, {0, 0}, 2), radius);
    const Region now = with_coarser_arcs(old, 0.02 * radius, reach);
    const Region lost = subtract(covered_from_boundary(old, reach), covered_from_boundary(now, reach));
    EXPECT_LT(area(lost), 6e-5 * reach * perimeter(old));
    EXPECT_LE(vertex_count(now), vertex_count(old) - (reach > radius ? 1 : 0));
  }
}

TEST(CoarserArcs, AQuarterTurnHasHalfTheVertices) {
  Region room = box_region({0, 0}, {10, 10});
  room.polygons[0].holes.push_back({{4, 4}, {4, 6}, {6, 6}, {6, 4}});
  const Region old = space_of(room, 0.2);
  const std::size_t before = old.polygons[0].holes[0].size();
  EXPECT_LE(2 * with_coarser_arcs(old, 0.002, 0.2).polygons[0].holes[0].size(), before + 4);
  EXPECT_EQ(with_coarser_arcs(old, 0.002, 0.1).polygons[0].holes[0].size(), before);  // the tool would leave seams
}

/// Two corners face each other in a passage narrower than twice the tolerance: arcs there stay apart.
TEST(CoarserArcs, FacingArcsDoNotMeet) {
  for (const double gap : {0.001, 0.01, 0.03, 0.1}) {
    SCOPED_TRACE(gap);
    Region room = box_region({0, 0}, {10, 10});
    room.polygons[0].holes.push_back({{3, 4}, {3, 6}, {5, 5}});
    room.polygons[0].holes.push_back({{5.4 + gap, 5}, {7.4 + gap, 6}, {7.4 + gap, 4}});
    expect_promises(space_of(room, 0.2), 0.02, std::numeric_limits<double>::infinity());
  }
}

}  // namespace
}  // namespace oxturn
