// Barriers across gaps, by brute force over all pairs of rings and by discs: the boundary curves of eroded free space.
#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <stdexcept>

#include "geometry/edge_index.hpp"
#include "geometry/mesh/mesh.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/tether/geodesic_field.hpp"
#include "random_region.hpp"

namespace oxturn {
namespace {

double ring_distance(const Ring& a, const Ring& b) {
  double best = 1e300;
  const auto from = [&](const Ring& p, const Ring& q) {
    for (const Point& v : p) {
      for (std::size_t i = 0; i < q.size(); ++i)
        best = std::min(best, distance_to_segment(v, q[i], q[(i + 1) % q.size()]));
    }
  };
  from(a, b);
  from(b, a);
  return best;
}

struct Groups {
  std::vector<std::size_t> parent;
  explicit Groups(std::size_t n) : parent(n) { std::iota(parent.begin(), parent.end(), std::size_t{0}); }
  std::size_t of(std::size_t i) const { return parent[i] == i ? i : of(parent[i]); }
  bool join(std::size_t i, std::size_t j) {
    if (of(i) == of(j)) return false;
    parent[of(i)] = of(j);
    return true;
  }
};

std::vector<Ring> rings_of(const Region& region) {
  std::vector<Ring> rings;
  for_each_ring(region, [&](const Ring& r) { rings.push_back(r); });
  return rings;
}

/// The ring that p lies on; fails if there is none.
std::size_t ring_at(const std::vector<Ring>& rings, const Point& p) {
  for (std::size_t k = 0; k < rings.size(); ++k) {
    if (ring_distance({p}, rings[k]) < 1e-12) return k;
  }
  ADD_FAILURE() << "a barrier ends off all rings at " << p.transpose();
  return 0;
}

/// Length of a minimum spanning forest over all pairs nearer than `width`, and the groups (Prim would do as well).
double forest(const std::vector<Ring>& rings, double width, Groups& groups, double& nearest_miss) {
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  nearest_miss = 1e300;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (std::size_t j = i + 1; j < rings.size(); ++j) {
      const double d = ring_distance(rings[i], rings[j]);
      nearest_miss = std::min(nearest_miss, std::abs(d - width));
      if (d < width) pairs.emplace_back(d, i, j);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  double sum = 0;
  for (const auto& [d, i, j] : pairs) {
    if (groups.join(i, j)) sum += d;
  }
  return sum;
}

void check(const Region& region, double width, bool with_discs) {
  const std::vector<Ring> rings = rings_of(region);
  Groups expected(rings.size()), joined(rings.size());
  double nearest_miss = 0, sum = 0;
  const double best = forest(rings, width, expected, nearest_miss);
  const EdgeIndex index(region);
  for (const Polyline& line : barriers(region, width)) {
    ASSERT_EQ(line.size(), 2u);
    EXPECT_LT(length(line), width);
    sum += length(line);
    EXPECT_TRUE(joined.join(ring_at(rings, line[0]), ring_at(rings, line[1]))) << "a circle of barriers";
    EXPECT_TRUE(index.contains(lerp(line[0], line[1], 1e-9), lerp(line[0], line[1], 1 - 1e-9)));
  }
  EXPECT_NEAR(sum, best, 1e-9 * (1 + best));
  for (std::size_t i = 0; i < rings.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_EQ(joined.of(i) == joined.of(j), expected.of(i) == expected.of(j));
  }
  if (!with_discs || nearest_miss < 2e-3) return;
  // Rings that the disc meets along one curve of its free space are joined, and along different curves they are not.
  const Region space = erode(region, width / 2, 1e-5, Bound::inside);
  for (const Polygon& part : space.polygons) {
    std::map<std::size_t, std::size_t> group_of_curve, curve_of_group;
    const std::vector<Ring> curves = rings_of({{part}});
    for (std::size_t c = 0; c < curves.size(); ++c) {
      for (std::size_t k = 0; k < rings.size(); ++k) {
        if (ring_distance(curves[c], rings[k]) > width / 2 + 5e-4) continue;
        EXPECT_EQ(group_of_curve.emplace(c, joined.of(k)).first->second, joined.of(k));
        EXPECT_EQ(curve_of_group.emplace(joined.of(k), c).first->second, c);
      }
    }
  }
}

TEST(Barriers, AreAMinimumForestAndCloseWhatADiscCannotPass) {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    const Region region = clutter_box(rng, rng.between(1, 4), rng.between(1, 4), false);
    check(region, rng.between(0.05, 0.6), true);
  }
}

TEST(Barriers, OnALattice) {
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    check(clutter_box(rng, rng.between(1, 4), rng.between(1, 4), true), 0.125 * rng.between(1, 5) + 0.05, true);
  }
}

TEST(Barriers, AGapAsWideAsTheDiscStaysOpen) {
  const Region region{{{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 3}, {2, 3}, {2, 1}}}}}};
  EXPECT_TRUE(barriers(region, 1).empty());
  EXPECT_TRUE(barriers(region, 0).empty());
  const std::vector<Polyline> lines = barriers(region, 1.0001);
  ASSERT_EQ(lines.size(), 1u);  // of three gaps: that suffices
  EXPECT_DOUBLE_EQ(length(lines[0]), 1);
}

TEST(Barriers, TouchingRingsNeedNone) {
  const Region region{
      {{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 0}, {0.5, 1}, {1.5, 1}}, {{1.5, 1}, {1.5, 2}, {2.5, 2}, {2.5, 1}}}}}};
  EXPECT_TRUE(barriers(region, 1.2).empty());
  EXPECT_THROW(barriers(region, -1), std::invalid_argument);
  EXPECT_THROW(barriers(region, std::nan("")), std::invalid_argument);
}

TEST(Barriers, OtherPolygonsAreBehindWalls) {
  Region region = box_region({0, 0}, {1, 1});
  region.polygons.push_back(box_region({1.1, 0}, {2, 1}).polygons.front());
  EXPECT_TRUE(barriers(region, 0.5).empty());
}

double mesh_area(const Mesh& mesh) {
  double sum = 0;
  for (const Mesh::Triangle& t : mesh.triangles()) {
    const auto at = [&](std::size_t k) { return mesh.points()[static_cast<std::size_t>(t.vertex[k])]; };
    sum += cross(at(1) - at(0), at(2) - at(0)) / 2;
  }
  return sum;
}

TEST(MeshWithBarriers, IsTheSameAreaWithWallsOnBothSidesOfThem) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    const Region region = clutter_box(rng, rng.between(1, 4), rng.between(1, 4), seed % 2 == 0);
    const std::vector<Polyline> lines = barriers(region, rng.between(0.1, 0.7));
    const Mesh plain(region), mesh(region, lines);
    EXPECT_NEAR(mesh_area(mesh), area(region), 1e-12 * area(region));
    std::size_t walls = 0, splits = mesh.points().size() - plain.points().size();
    for (const Mesh::Triangle& t : mesh.triangles()) {
      for (std::size_t k = 0; k < 3; ++k) walls += t.neighbour[k] == Mesh::kWall ? 1u : 0u;
    }
    // Every ring edge once, every barrier from both sides; a point inside an edge makes two edges of it.
    EXPECT_EQ(walls, vertex_count(region) + splits + 2 * lines.size());
    for (std::size_t i = 0; i < mesh.points().size(); ++i) {
      const bool fresh = i >= plain.points().size();
      const auto id = static_cast<std::int32_t>(i);
      EXPECT_TRUE(!mesh.is_reflex(id) || (!fresh && plain.is_reflex(id))) << mesh.points()[i].transpose();
    }
  }
}

TEST(MeshWithBarriers, ABarrierInTheOpenBendsPathsAtItsEnd) {
  const Region box = box_region({0, 0}, {4, 4});
  const Mesh mesh(box, {{{2, 0}, {2, 3}}});
  ASSERT_EQ(mesh.points().size(), 6u);
  EXPECT_FALSE(mesh.is_reflex(4) && mesh.is_reflex(5));
  EXPECT_TRUE(mesh.is_reflex(4) || mesh.is_reflex(5));  // the end at (2, 3) sees all round
  const GeodesicField field(box, {1, 1}, {{{2, 0}, {2, 3}}}, 1e-9);
  EXPECT_NEAR(field.distance({3, 1}), 2 * std::sqrt(5.0), 1e-12);
  EXPECT_EQ(field.path({3, 1}), (Polyline{{1, 1}, {2, 3}, {3, 1}}));
}

TEST(MeshWithBarriers, RefusesWhatIsNotFinite) {
  EXPECT_THROW(Mesh(box_region({0, 0}, {1, 1}), {{{0, 0}, {std::nan(""), 1}}}), std::invalid_argument);
}

}  // namespace
}  // namespace oxturn
