#include "geometry/overlay/minkowski.hpp"

#include <gtest/gtest.h>

#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/validity.hpp"
#include "tests/geometry/random_region.hpp"
#include "tests/geometry/samples.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

Ring octagon(double width) {
  Ring ring;
  for (int k = 0; k < 8; ++k) ring.push_back(rotated({width / 2 / std::cos(kPi / 8), 0}, (2 * k + 1) * kPi / 8));
  return ring;
}

/// How many times as large the body would have to be to touch the wall ab from p: the least of a maximum of linear
/// functions along a segment, looked for where two of them are equal.
double gauge(const Ring& body, const Point& p, const Point& a, const Point& b) {
  std::vector<std::pair<double, double>> sides;  // at a, at b
  for (std::size_t i = 0; i < body.size(); ++i) {
    const Point along = body[(i + 1) % body.size()] - body[i], out = -perpendicular(along);
    const double reach = out.dot(body[i]);
    sides.emplace_back(out.dot(a - p) / reach, out.dot(b - p) / reach);
  }
  const auto at = [&](double t) {
    double most = -1e300;
    for (const auto& [s, e] : sides) most = std::max(most, s + t * (e - s));
    return most;
  };
  double least = std::min(at(0), at(1));
  for (const auto& [s, e] : sides)
    for (const auto& [u, v] : sides) {
      const double t = (u - s) / ((e - s) - (v - u));
      if (t > 0 && t < 1) least = std::min(least, at(t));
    }
  return least;
}

double gauge(const Ring& body, const Point& p, const Region& region) {
  double least = 1e300;
  for_each_ring(region, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      least = std::min(least, gauge(body, p, ring[i], ring[(i + 1) % ring.size()]));
  });
  return least;
}

/// The same by definition: the region without, edge by edge, the hull of the reflected body at both ends.
Region less_swept_edges(const Region& region, const Ring& body) {
  std::vector<Region> parts;
  for_each_ring(region, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
      std::vector<Region> hull;
      Ring at_a, at_b;
      for (const Point& q : body) {
        at_a.push_back(a - q);
        at_b.push_back(b - q);
      }
      hull.push_back({{{at_a, {}}}});
      hull.push_back({{{at_b, {}}}});
      for (std::size_t k = 0; k < body.size(); ++k) {
        const Point &q = body[k], &r = body[(k + 1) % body.size()];
        Ring quad{a - q, a - r, b - r, b - q};  // what a side of the body sweeps
        if (signed_area(quad) < 0) std::reverse(quad.begin(), quad.end());
        if (signed_area(quad) > 1e-12) hull.push_back({{{quad, {}}}});
      }
      parts.push_back(unite(hull));
    }
  });
  return subtract(region, unite(parts));
}

TEST(Minkowski, ABoxAndAnOctagonByTheBook) {
  const Region in = erode(box_region({1, 1}, {6, 4}), octagon(1), Bound::inside);
  EXPECT_EQ(vertex_count(in), 4u);
  EXPECT_NEAR(area(in), 4 * 2, 1e-6);
  EXPECT_LE(area(in), 8);
  EXPECT_GE(area(erode(box_region({1, 1}, {6, 4}), octagon(1), Bound::outside)), 8);
  // Round a square pillar of side 1 the octagon of width 1 keeps off their sum, whose area is that of both and twice
  // the mixed one.
  Region pillar = box_region({0, 0}, {10, 10});
  pillar.polygons[0].holes.push_back({{4, 4}, {4, 5}, {5, 5}, {5, 4}});
  const double own = signed_area(octagon(1)), sum = 1 + own + 4 * 0.5;  // square + octagon + 4 sides x half width
  EXPECT_NEAR(area(erode(pillar, octagon(1), Bound::inside)), 81 - sum, 1e-5);
}

TEST(Minkowski, AsymmetricBodiesAreReflected) {
  const Ring arrow{{2, 0}, {-1, 1}, {-1, -1}};  // far to the right
  const Region in = erode(box_region({0, 0}, {10, 10}), arrow, Bound::inside);
  const Box box = bounding_box(in);
  EXPECT_NEAR(box.low.x(), 1, 1e-6);
  EXPECT_NEAR(box.high.x(), 8, 1e-6);
  EXPECT_NEAR(box.low.y(), 1, 1e-6);
}

TEST(Minkowski, BoundsHoldByBruteForce) {
  for (const std::uint64_t seed : seeds(80)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Region map = seed % 3 == 0 ? samples::holed_star(rng, {2, 2}, 2) : clutter_box(rng, 4, 3, seed % 3 == 1);
    Ring body = seed % 4 == 0 ? octagon(0.3) : convex_ring(rng, {0, 0}, rng.between(0.05, 0.3), rng.between(4, 9));
    for (Point& p : body) p += Point(0.01, -0.005);  // the centre is not in the middle
    const Region in = erode(map, body, Bound::inside), out = erode(map, body, Bound::outside);
    EXPECT_FALSE(find_flaw(in));
    EXPECT_FALSE(find_flaw(out));
    Box box = bounding_box(map);
    for (int k = 0; k < 150; ++k) {
      const Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
      const double g = contains(map, p) ? gauge(body, p, map) : 0;
      if (contains(in, p)) { EXPECT_GE(g, 1) << p.transpose(); }
      if (!contains(out, p)) { EXPECT_LT(g, 1) << p.transpose(); }
      if (g > 1 + 1e-5) { EXPECT_TRUE(contains(in, p)) << p.transpose(); }
      if (g < 1 - 1e-5) { EXPECT_FALSE(contains(out, p)) << p.transpose(); }
    }
    for (const Point& p : samples::boundary_points(in, 2)) EXPECT_GE(gauge(body, p, map), 1) << p.transpose();
  }
}

TEST(Minkowski, IsTheRegionLessItsSweptEdges) {
  for (const std::uint64_t seed : seeds(40)) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Region map = clutter_box(rng, 4, 3, seed % 2 == 0);
    const Ring body = seed % 4 < 2 ? octagon(0.25) : convex_ring(rng, {0, 0}, 0.2, 5);
    const Region in = erode(map, body, Bound::inside), other = less_swept_edges(map, body);
    EXPECT_NEAR(area(in), area(other), 1e-5);
    EXPECT_NEAR(area(intersect(in, other)), area(in), 1e-5);
  }
}

TEST(Minkowski, APolygonOfManyCornersIsNearlyADisc) {
  Rng rng(5);
  const Region map = clutter_box(rng, 6, 5, false);
  Ring round;
  for (int k = 0; k < 64; ++k) round.push_back(rotated({0.1, 0}, k * kPi / 32));  // inscribed
  const double in = area(erode(map, round, Bound::inside)), disc = area(erode(map, 0.1, 1e-5, Bound::outside));
  const double smaller = area(erode(map, 0.1 * std::cos(kPi / 64), 1e-5, Bound::outside));
  EXPECT_GE(in, disc - 1e-6);
  EXPECT_LE(in, smaller + 1e-6);
}

TEST(Minkowski, AlongAFineCurve) {
  // A round room of 4000 chords: the octagon's centre stays in an intersection of eight shifted rooms.
  Ring room;
  for (int k = 0; k < 4000; ++k) room.push_back(rotated({5, 0}, 2 * kPi * k / 4000));
  Region expected{{{room, {}}}};
  for (const Point& q : octagon(1)) expected = intersect(expected, transformed({{{room, {}}}}, 0, -q));
  EXPECT_NEAR(area(erode({{{room, {}}}}, octagon(1), Bound::inside)), area(expected), 1e-5);
}

TEST(Minkowski, NarrowAndDegenerate) {
  EXPECT_TRUE(erode(box_region({0, 0}, {5, 0.99}), octagon(1), Bound::inside).empty());
  EXPECT_FALSE(erode(box_region({0, 0}, {5, 1.01}), octagon(1), Bound::inside).empty());
  EXPECT_TRUE(erode(Region{}, octagon(1), Bound::inside).empty());
  EXPECT_THROW(erode(box_region({0, 0}, {1, 1}), Ring{}, Bound::inside), std::invalid_argument);
  EXPECT_THROW(erode(box_region({0, 0}, {1, 1}), Ring{{1, 1}, {2, 1}, {1, 2}}, Bound::inside), std::invalid_argument);
  EXPECT_THROW(erode(box_region({0, 0}, {1, 1}), Ring{{1, std::nan("")}, {-1, 1}, {0, -1}}, Bound::inside),
               std::invalid_argument);
  // A hole smaller than the lattice resolves is still in the path.
  Region speck = box_region({0, 0}, {10, 10});
  speck.polygons[0].holes.push_back({{5, 5}, {5, 5 + 1e-13}, {5 + 1e-13, 5}});
  EXPECT_NEAR(area(erode(speck, octagon(1), Bound::inside)), 81 - signed_area(octagon(1)), 1e-5);
}

}  // namespace
}  // namespace oxturn
