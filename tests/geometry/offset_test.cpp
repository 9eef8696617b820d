#include "geometry/overlay/offset.hpp"

#include <gtest/gtest.h>

#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/validity.hpp"
#include "tests/geometry/samples.hpp"

namespace oxturn {
namespace {

constexpr double kSnap = 1e-6;  // generous against the lattice of maps a few metres wide

TEST(Offset, BoxGrowsAndShrinksByTheBook) {
  const Region box = box_region({1, 1}, {4, 3});
  const double r = 0.25, round = 6 + 2 * 5 * r + kPi * r * r;
  EXPECT_NEAR(area(dilate(box, r, 1e-5, Bound::inside)), round, 1e-4);
  EXPECT_NEAR(area(dilate(box, r, 1e-5, Bound::outside)), round, 1e-4);
  EXPECT_LE(area(dilate(box, r, 1e-2, Bound::inside)), round);
  EXPECT_GE(area(dilate(box, r, 1e-2, Bound::outside)), round);
  const Region in = erode(box, r, 1e-3, Bound::inside);
  EXPECT_EQ(vertex_count(in), 4u);  // straight walls carry no chord error
  EXPECT_NEAR(area(in), 2.5 * 1.5, kSnap * 8);
  EXPECT_LE(area(in), 2.5 * 1.5);
  EXPECT_GE(area(erode(box, r, 1e-3, Bound::outside)), 2.5 * 1.5);
}

/// How many vertices of the region lie on a straight line with their neighbours.
std::size_t straight_vertices(const Region& region) {
  std::size_t count = 0;
  for_each_ring(region, [&](const Ring& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point before = ring[i] - ring[(i + ring.size() - 1) % ring.size()];
      const Point after = ring[(i + 1) % ring.size()] - ring[i];
      count += std::abs(cross(before, after)) < 1e-4 * before.norm() * after.norm() ? 1 : 0;
    }
  });
  return count;
}

// An arc's first and last tangents are the shifted edges themselves.
TEST(Offset, TangentsAddNoVerticesToStraightWalls) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Rng rng(seed);
    Region map = box_region({0, 0}, {10, 10});
    const Point turned = rotated({1, 0.3}, rng.between(0, 1));
    const Ring block{Point(5, 5) + turned, Point(5, 5) + perpendicular(turned), Point(5, 5) - turned,
                     Point(5, 5) - perpendicular(turned)};
    map = subtract(map, {{Polygon{block, {}}}});
    const double error = rng.between(1e-4, 1e-2), half = std::acos(1 / (1 + error / 0.3));
    const Region in = erode(map, 0.3, error, Bound::inside);
    EXPECT_EQ(straight_vertices(in), 0u) << seed;
    EXPECT_NEAR(static_cast<double>(vertex_count(in)), 4 + 4 * std::ceil(kPi / 4 / half), 4) << seed;
    EXPECT_EQ(straight_vertices(dilate({{Polygon{block, {}}}}, 0.3, error, Bound::outside)), 0u) << seed;
  }
}

TEST(Offset, TooNarrowIsEmpty) {
  EXPECT_TRUE(erode(box_region({0, 0}, {5, 0.39}), 0.2, 1e-3, Bound::inside).empty());
  EXPECT_FALSE(erode(box_region({0, 0}, {5, 0.41}), 0.2, 1e-3, Bound::inside).empty());
  EXPECT_TRUE(erode(Region{}, 0.2, 1e-3, Bound::inside).empty());
  EXPECT_TRUE(dilate(Region{}, 0.2, 1e-3, Bound::inside).empty());
}

TEST(Offset, ARadiusOfZeroChangesNothing) {
  Rng rng(2);
  const Region r = samples::holed_star(rng, {0, 0}, 1);
  EXPECT_EQ(erode(r, 0, 1e-3, Bound::inside).polygons[0].outer, r.polygons[0].outer);
}

TEST(Offset, RefusesSenselessLengths) {
  const Region box = box_region({0, 0}, {1, 1});
  EXPECT_THROW(erode(box, -1, 1e-3, Bound::inside), std::invalid_argument);
  EXPECT_THROW(erode(box, std::nan(""), 1e-3, Bound::inside), std::invalid_argument);
  EXPECT_THROW(dilate(box, 1, 0, Bound::inside), std::invalid_argument);
}

/// Points certain by brute force: the region and its distance to p.
double depth(const Region& r, const Point& p) {  // positive inside
  const double d = samples::distance_to_boundary(r, p);
  return contains(r, p) ? d : -d;
}

void expect_bounds(const Region& map, double r, double error, Rng& rng, int points) {
  const Region in = erode(map, r, error, Bound::inside), out = erode(map, r, error, Bound::outside);
  const Region grown_in = dilate(map, r, error, Bound::inside), grown_out = dilate(map, r, error, Bound::outside);
  for (const Region* x : {&in, &out, &grown_in, &grown_out}) EXPECT_FALSE(find_flaw(*x));
  // Every corner keeps its promise: that is where bounds break first.
  for (const Point& p : samples::boundary_points(in, 2)) {
    EXPECT_GE(depth(map, p), r) << p.transpose();
    EXPECT_LE(depth(map, p), r + error + kSnap) << p.transpose();
  }
  for (const Point& p : samples::boundary_points(out, 2)) {
    EXPECT_LE(depth(map, p), r) << p.transpose();
    EXPECT_GE(depth(map, p), r - error - kSnap) << p.transpose();
  }
  for (const Point& p : samples::boundary_points(grown_in, 2)) {
    EXPECT_GE(depth(map, p), -r) << p.transpose();
    EXPECT_LE(depth(map, p), -r + error + kSnap) << p.transpose();
  }
  for (const Point& p : samples::boundary_points(grown_out, 2)) {
    EXPECT_LE(depth(map, p), -r) << p.transpose();
    EXPECT_GE(depth(map, p), -r - error - kSnap) << p.transpose();
  }
  // And nothing is forgotten or left over in between.
  Box box = bounding_box(map);
  box.grow(1.5 * r);
  for (int k = 0; k < points; ++k) {
    const Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
    const double d = depth(map, p);
    if (d > r + error + kSnap) { EXPECT_TRUE(contains(in, p)) << p.transpose(); }
    if (d < r) { EXPECT_FALSE(contains(in, p)) << p.transpose(); }
    if (d > r) { EXPECT_TRUE(contains(out, p)) << p.transpose(); }
    if (d < r - error - kSnap) { EXPECT_FALSE(contains(out, p)) << p.transpose(); }
    if (d > -r + error + kSnap) { EXPECT_TRUE(contains(grown_in, p)) << p.transpose(); }
    if (d < -r) { EXPECT_FALSE(contains(grown_in, p)) << p.transpose(); }
    if (d > -r) { EXPECT_TRUE(contains(grown_out, p)) << p.transpose(); }
    if (d < -r - error - kSnap) { EXPECT_FALSE(contains(grown_out, p)) << p.transpose(); }
  }
}

TEST(Offset, BoundsAreCertainOnStars) {
  Rng rng(31);
  for (int round = 0; round < 12; ++round) {
    SCOPED_TRACE(round);
    expect_bounds(samples::holed_star(rng, {5, 5}, 3), rng.between(0.01, 1.0), rng.between(0.001, 0.05), rng, 300);
  }
}

TEST(Offset, BoundsAreCertainOnTracedMaps) {
  Rng rng(32);
  for (int round = 0; round < 4; ++round) {
    SCOPED_TRACE(round);
    expect_bounds(trace(samples::speckled(rng, 60, 0.05, 40, 8)), rng.between(0.02, 0.4), 0.0005, rng, 500);
  }
}

// Concave chains left by an earlier offset, undone at the same, a smaller and a larger radius.
TEST(Offset, BoundsAreCertainOnArcs) {
  Rng rng(33);
  Region map = box_region({0, 0}, {4, 4});
  for (int k = 0; k < 5; ++k)
    map =
        subtract(map, {{Polygon{samples::star(rng, {rng.between(1.0, 3.0), rng.between(1.0, 3.0)}, 0.1, 0.3, 7), {}}}});
  const Region config = erode(map, 0.2, 4e-4, Bound::inside);
  for (const double r : {0.1, 0.2, 0.3}) {
    SCOPED_TRACE(r);
    expect_bounds(config, r, 4e-4, rng, 300);
  }
  EXPECT_LT(area(subtract(dilate(config, 0.2, 4e-4, Bound::inside), map)), 1e-9);
}

/// A hall with obstacles of many kinds: stars, round ones, uneven convex ones, cells that touch at corners.
Region small_hall(Rng& rng) {
  Region map = box_region({0, 0}, {4, 4});
  const int obstacles = rng.between(1, 4);
  for (int k = 0; k < obstacles; ++k) {
    const Point at(rng.between(0.5, 3.5), rng.between(0.5, 3.5));
    const double size = rng.between(0.02, 0.6);
    Ring ring;
    switch (rng.between(0, 3)) {
      case 0:
        ring = samples::star(rng, at, size / 3, size, rng.between(5, 9));
        break;
      case 1:
        ring = samples::star(rng, at, size, size, rng.between(8, 60));
        break;
      case 2:
        for (const Point& p : samples::star(rng, {0, 0}, size, size, rng.between(5, 30)))
          ring.push_back(at + Point(p.x(), 0.3 * p.y()));
        break;
      default:
        map = subtract(map, box_region(at, at + Point(size, size)));
        ring = {at + Point(size, size), at + Point(2 * size, size), at + Point(2 * size, 2 * size)};
    }
    map = subtract(map, {{Polygon{ring, {}}}});
  }
  return map;
}

TEST(Offset, BoundsAreCertainOnManySmallHalls) {
  Rng rng(35);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    const double r = rng.between(0.05, 0.35), error = r * std::pow(10.0, rng.between(-3.0, -1.5));
    const Region space = erode(small_hall(rng), r, error, rng.chance(0.8) ? Bound::inside : Bound::outside);
    const double again = rng.chance(0.5) ? r : r * rng.between(0.3, 1.5);
    if (!space.empty()) expect_bounds(space, again, error, rng, 20);
  }
}

/// The region and everything within r of its boundary, as a union of its edges' rectangles and its corners' polygons,
/// which lie inside of their discs or round them.
Region swept_boundary(const Region& region, double r, int corners, bool outside) {
  std::vector<Region> parts{region};
  for_each_ring(region, [&](const Ring& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Point across = r * perpendicular((ring[i] - ring[j]).normalized());
      parts.push_back({{Polygon{{ring[j] - across, ring[i] - across, ring[i] + across, ring[j] + across}, {}}}});
      Ring disc;
      for (int k = 0; k < corners; ++k)
        disc.push_back(ring[i] + (outside ? r / std::cos(kPi / corners) : r) *
                                     Point(std::cos(2 * kPi * k / corners), std::sin(2 * kPi * k / corners)));
      parts.push_back({{Polygon{disc, {}}}});
    }
  });
  return unite(parts);
}

TEST(Offset, GrownAreasAgreeWithASweptBoundary) {
  Rng rng(36);
  for (int round = 0; round < 20; ++round) {
    SCOPED_TRACE(round);
    const double r = rng.between(0.05, 0.35);
    const Region space = erode(small_hall(rng), r, 2e-3, Bound::inside);
    if (space.empty()) continue;
    const double again = rng.chance(0.5) ? r : r * rng.between(0.3, 1.5), error = 1e-4;
    const Region in = dilate(space, again, error, Bound::inside), out = dilate(space, again, error, Bound::outside);
    const Region swept_in = swept_boundary(space, again, 48, false), swept_out = swept_boundary(space, again, 48, true);
    const double snap = 1e-6 * perimeter(swept_out);
    EXPECT_LE(area(swept_in), area(out) + snap);
    EXPECT_GE(area(swept_out), area(in) - snap);
    EXPECT_LT(area(subtract(in, swept_out)), snap);
    EXPECT_LT(area(subtract(swept_in, out)), snap);
    EXPECT_GE(area(out), area(in));
    EXPECT_LE(area(out), area(in) + error * perimeter(out) + snap);
  }
}

TEST(Offset, DoesNotDependOnPositionOrDirection) {
  Rng rng(34);
  const Region map = samples::holed_star(rng, {0, 0}, 2);
  const double a = area(erode(map, 0.1, 1e-4, Bound::inside));
  EXPECT_NEAR(area(erode(transformed(map, 1.1, {300, -200}), 0.1, 1e-4, Bound::inside)), a, 1e-3);
  EXPECT_NEAR(area(erode(transformed(map, 0, {1e6, 1e6}), 0.1, 1e-4, Bound::inside)), a, 1e-6);
  Region turned = map;  // rings of the wrong orientation are read as meant
  std::reverse(turned.polygons[0].outer.begin(), turned.polygons[0].outer.end());
  EXPECT_EQ(area(erode(turned, 0.1, 1e-4, Bound::inside)), a);
}

TEST(Offset, BetweenOffsetsIsErosionLessDilation) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Region outer = samples::holed_star(rng, {0, 0}, 4);
    const double step = rng.between(0.1, 0.6), radius = rng.between(0.5, 0.9) * step, error = radius / 100;
    const Region inner = erode(outer, step, error, Bound::inside);
    const Region expected =
        subtract(erode(outer, radius, error, Bound::inside), dilate(inner, radius, error, Bound::outside));
    const Region found = between_offsets(outer, inner, radius, error);
    EXPECT_FALSE(find_flaw(found));
    EXPECT_LT(area(subtract(found, expected)) + area(subtract(expected, found)), 1e-6);
  }
  const Region box = box_region({0, 0}, {4, 3});
  EXPECT_NEAR(area(between_offsets(box, {}, 0.5, 1e-3)), 6, kSnap);  // nothing inside
  EXPECT_TRUE(between_offsets({}, box, 0.5, 1e-3).empty());
  EXPECT_THROW(between_offsets(box, box, 0, 1e-3), std::invalid_argument);
}

TEST(Offset, DilationFallsShortByNoMoreThanItsBound) {
  const Region box = box_region({1, 1}, {4, 3});
  for (const double error : {1e-2, 1e-3, 1e-5}) {
    const double r = 0.25, missing = 6 + 2 * 5 * r + kPi * r * r - area(dilate(box, r, error, Bound::inside));
    EXPECT_GT(missing, 0);
    EXPECT_LE(missing, dilation_shortfall(box, r, error));
    EXPECT_LE(dilation_shortfall(box, r, error), 1.5 * missing + 1e-6);
  }
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const Region r = samples::holed_star(rng, {0, 0}, 4);
    const double radius = rng.between(0.05, 0.6), error = radius / rng.between(20, 2000);
    const double finest = area(dilate(r, radius, radius * 1e-6, Bound::inside));
    EXPECT_LE(finest - area(dilate(r, radius, error, Bound::inside)), dilation_shortfall(r, radius, error));
  }
  EXPECT_EQ(dilation_shortfall(box, 0, 1e-3), 0);
  EXPECT_EQ(dilation_shortfall({}, 1, 1e-3), 0);
  EXPECT_THROW(dilation_shortfall(box, -1, 1e-3), std::invalid_argument);
}

}  // namespace
}  // namespace oxturn
