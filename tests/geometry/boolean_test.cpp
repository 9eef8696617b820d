#include "geometry/overlay/boolean.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/edge_index.hpp"
#include "geometry/overlay/validity.hpp"
#include "tests/geometry/samples.hpp"

namespace oxturn {
namespace {

void expect_sound(const Region& r) {
  const auto flaw = find_flaw(r);
  EXPECT_FALSE(flaw) << flaw->reason << " at " << flaw->point.transpose();
  for (const Polygon& p : r.polygons) {
    EXPECT_GT(signed_area(p.outer), 0);
    for (const Ring& h : p.holes) EXPECT_LT(signed_area(h), 0);
  }
}

void expect_same(const Region& a, const Region& b) {
  ASSERT_EQ(a.polygons.size(), b.polygons.size());
  for (std::size_t k = 0; k < a.polygons.size(); ++k) {
    EXPECT_EQ(a.polygons[k].outer, b.polygons[k].outer);
    EXPECT_EQ(a.polygons[k].holes, b.polygons[k].holes);
  }
}

// Points decide: inside the result if and only if inside the operands as the operation says.
TEST(Boolean, AgreesWithPointsAndWithItself) {
  Rng rng(21);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    const Region a = samples::holed_star(rng, {0, 0}, 2), b = samples::holed_star(rng, {rng.unit(), rng.unit()}, 2);
    const Region both = intersect(a, b), either = unite({a, b}), only_a = subtract(a, b), only_b = subtract(b, a);
    for (const Region* r : {&both, &either, &only_a, &only_b}) expect_sound(*r);
    const DividedRegion parts = divided(a, b);
    expect_same(parts.outside, only_a);
    expect_same(parts.inside, both);
    EXPECT_NEAR(area(either) + area(both), area(a) + area(b), 1e-6);
    EXPECT_NEAR(area(only_a) + area(both), area(a), 1e-6);
    EXPECT_NEAR(area(only_a) + area(only_b) + area(both), area(either), 1e-6);
    for (int k = 0; k < 200; ++k) {
      const Point p(rng.between(-2.5, 3.5), rng.between(-2.5, 3.5));
      if (std::min(samples::distance_to_boundary(a, p), samples::distance_to_boundary(b, p)) < 1e-7) continue;
      const bool in_a = samples::sees_all_round(a, p), in_b = samples::sees_all_round(b, p);
      EXPECT_EQ(contains(both, p), in_a && in_b);
      EXPECT_EQ(contains(either, p), in_a || in_b);
      EXPECT_EQ(contains(only_a, p), in_a && !in_b);
    }
  }
}

TEST(Boolean, ResultsAreFixedPoints) {
  Rng rng(22);
  for (int round = 0; round < 20; ++round) {
    const Region a = samples::holed_star(rng, {0, 0}, 2), b = samples::holed_star(rng, {1, 0}, 2);
    const Region u = unite({a, b});
    expect_same(unite({u}), u);
    expect_same(intersect(u, u), u);
    expect_same(unite({u, u}), u);
    EXPECT_TRUE(subtract(u, u).empty());
    expect_same(unite({b, a}), u);
  }
}

TEST(Boolean, EmptyOperands) {
  const Region a = box_region({0, 0}, {1, 1});
  EXPECT_TRUE(unite({}).empty());
  EXPECT_TRUE(unite({Region{}, Region{}}).empty());
  EXPECT_TRUE(intersect(a, Region{}).empty());
  EXPECT_TRUE(subtract(Region{}, a).empty());
  EXPECT_EQ(area(subtract(a, Region{})), 1);
  EXPECT_TRUE(intersect(a, box_region({2, 2}, {3, 3})).empty());
}

TEST(Boolean, SharedWallsVanishExactly) {
  const Region r = unite({box_region({0, 0}, {0.3, 1}), box_region({0.3, 0}, {1, 1})});
  ASSERT_EQ(vertex_count(r), 4u);
  EXPECT_NEAR(area(r), 1, 1e-8);
}

// Also off the axes, where shared walls are not exactly in line after rounding.
TEST(Boolean, ATurnedCheckerboardGrowsTogether) {
  std::vector<Region> parts;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j)
      parts.push_back(transformed(box_region({i * 0.1, j * 0.1}, {i * 0.1 + 0.1, j * 0.1 + 0.1}), 0.3, {100, 50}));
  const Region r = unite(parts);
  expect_sound(r);
  EXPECT_EQ(r.polygons.size(), 1u);
  EXPECT_EQ(hole_count(r), 0u);
  EXPECT_NEAR(area(r), 4, 1e-5);
}

TEST(Boolean, CornersThatTouchStaySeparateRings) {
  const Region r = unite({box_region({0, 0}, {1, 1}), box_region({1, 1}, {2, 2})});
  ASSERT_EQ(r.polygons.size(), 2u);
  EXPECT_EQ(vertex_count(r), 8u);
  // A ring of boxes whose court touches the outside in a point: outer ring and hole.
  const Region court =
      subtract(box_region({0, 0}, {3, 3}), unite({box_region({0, 0}, {1, 1}), box_region({1, 1}, {2, 2})}));
  ASSERT_EQ(court.polygons.size(), 1u);
  EXPECT_EQ(hole_count(court), 1u);
  EXPECT_NEAR(area(court), 7, 1e-8);
  // Two holes that touch in a point.
  const Region two =
      subtract(box_region({0, 0}, {5, 5}), unite({box_region({1, 1}, {2, 2}), box_region({2, 2}, {3, 3})}));
  EXPECT_EQ(hole_count(two), 2u);
}

TEST(Boolean, IslandsInHolesBelongWhereTheyLie) {
  Region r = box_region({0, 0}, {9, 9});
  for (int depth = 1; depth < 4; ++depth) {
    const Region next = box_region({depth * 1.0, depth * 1.0}, {9.0 - depth, 9.0 - depth});
    r = depth % 2 ? subtract(r, next) : unite({r, next});
  }
  ASSERT_EQ(r.polygons.size(), 2u);
  EXPECT_EQ(r.polygons[0].holes.size(), 1u);
  EXPECT_EQ(r.polygons[1].holes.size(), 1u);
  EXPECT_NEAR(area(r), 81 - 49 + 25 - 9, 1e-7);
}

// Slivers thinner than the lattice, needles and near-misses must not break anything.
TEST(Boolean, NearlyEqualOperandsStaySound) {
  Rng rng(23);
  for (int round = 0; round < 50; ++round) {
    const Region a = samples::holed_star(rng, {0, 0}, 1);
    const Region b = transformed(a, rng.normal() * 1e-9, {rng.normal() * 1e-9, rng.normal() * 1e-9});
    for (const Region& r : {unite({a, b}), intersect(a, b), subtract(a, b)}) expect_sound(r);
    EXPECT_NEAR(area(unite({a, b})), area(a), 1e-6);
    EXPECT_LT(area(subtract(a, b)), 1e-6);
  }
}

TEST(Boolean, WorksAtAnyScaleAndPosition) {
  for (const double scale : {1e-6, 1e-3, 1.0, 1e5})
    for (const double far : {0.0, 1e6}) {
      const Region a = box_region({far, far}, {far + scale, far + scale});
      const Region b = box_region({far + scale / 2, far}, {far + 2 * scale, far + scale});
      const double slack = 4 * std::max(scale * 1e-8, far * 1e-15) * scale;
      EXPECT_NEAR(area(unite({a, b})), 2 * scale * scale, slack) << scale << ' ' << far;
    }
}

TEST(Boolean, ManyPartsStackedDeep) {
  Rng rng(24);
  std::vector<Region> parts;
  Box box;
  for (int k = 0; k < 2000; ++k) {
    const Point at(rng.unit(), rng.unit());
    parts.push_back({{Polygon{samples::star(rng, at, 0.2, 0.2, 16), {}}}});
    for (const Point& p : parts.back().polygons[0].outer) box.add(p);
  }
  const Region u = unite(parts);
  expect_sound(u);
  EXPECT_EQ(u.polygons.size(), 1u);
  EXPECT_LT(distance(bounding_box(u).low, box.low), 1e-8);
  for (int k = 0; k < 1000; ++k) {
    const Point p(rng.between(-0.3, 1.3), rng.between(-0.3, 1.3));
    if (samples::distance_to_boundary(u, p) < 1e-7) continue;
    EXPECT_EQ(contains(u, p), std::any_of(parts.begin(), parts.end(), [&](const Region& r) { return contains(r, p); }));
  }
}

/// A band that winds round a point: seen from the left, its turns are connected only at the far right.
Region wound_band(const Point& centre, int turns, double pitch, int per_turn) {
  Ring band;
  const auto add = [&](int k, double off) {
    const double angle = 2 * kPi * k / per_turn;
    band.push_back(centre + (off + pitch * (1 + double(k) / per_turn)) * Point(std::cos(angle), std::sin(angle)));
  };
  for (int k = 0; k <= turns * per_turn; ++k) add(k, pitch / 2);
  for (int k = turns * per_turn; k >= 0; --k) add(k, 0);
  return {{Polygon{band, {}}}};
}

// Overlays of many edges find their winding numbers from left to right, and components whose surroundings are not known
// yet wait.
TEST(Boolean, LargeOverlaysAgreeWithPoints) {
  Rng rng(28);
  constexpr int kStars = 40;
  Region stars;
  for (int i = 0; i < kStars; ++i)
    for (int j = 0; j < kStars; ++j)
      stars.polygons.push_back(samples::holed_star(rng, {i + rng.unit() / 20, j + rng.unit() / 20}, 0.45).polygons[0]);
  for (const double pitch : {0.21, 0.9, 6.0}) {
    SCOPED_TRACE(pitch);
    const Point middle(kStars / 2.0, kStars / 2.0);
    const Region band = wound_band(middle, static_cast<int>(25 / pitch), pitch, 400);
    const Region both = intersect(stars, band), rest = subtract(stars, band);
    expect_sound(both);
    expect_sound(rest);
    EXPECT_NEAR(area(both) + area(rest), area(stars), 1e-5);
    const EdgeIndex in_stars(stars), in_band(band), in_both(both), in_rest(rest);
    for (int k = 0; k < 20000; ++k) {
      const Point p = rng.unit() * kStars * Point(1, 0) + rng.unit() * kStars * Point(0, 1);
      if (in_stars.nearest(p, 1e-6) || in_band.nearest(p, 1e-6)) continue;
      ASSERT_EQ(in_both.contains(p), in_stars.contains(p) && in_band.contains(p)) << p.transpose();
      ASSERT_EQ(in_rest.contains(p), in_stars.contains(p) && !in_band.contains(p)) << p.transpose();
    }
  }
}

TEST(Boolean, RefusesWhatIsNotANumber) {
  const Region bad = box_region({0, 0}, {1, std::nan("")});
  EXPECT_THROW(unite({bad}), std::invalid_argument);
  EXPECT_THROW(intersect(bad, bad), std::invalid_argument);
}

}  // namespace
}  // namespace oxturn
