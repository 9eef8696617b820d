#include "geometry/overlay/validity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/overlay/boolean.hpp"
#include "tests/geometry/samples.hpp"

namespace oxturn {
namespace {

using samples::reversed;

Region polygon(Ring outer, std::vector<Ring> holes = {}) { return {{Polygon{std::move(outer), std::move(holes)}}}; }
Ring square(double x, double y, double size) { return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}}; }

void expect_fixed(const Region& r) {
  const Region again = repaired(r);
  ASSERT_EQ(again.polygons.size(), r.polygons.size());
  for (std::size_t k = 0; k < r.polygons.size(); ++k) {
    EXPECT_EQ(again.polygons[k].outer, r.polygons[k].outer);
    EXPECT_EQ(again.polygons[k].holes, r.polygons[k].holes);
  }
}

TEST(FindFlaw, NamesReasonAndPoint) {
  const auto bow = find_flaw(polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}}));
  ASSERT_TRUE(bow);
  EXPECT_EQ(bow->reason, "edges cross");
  EXPECT_LT(distance(bow->point, {1, 1}), 1e-12);
  EXPECT_EQ(find_flaw(polygon({{0, 0}, {1, std::nan("")}, {2, 0}}))->reason, "coordinate is not a finite number");
  EXPECT_EQ(find_flaw(polygon({{0, 0}, {1, 1}, {0, 0}, {1, 1}}))->reason, "ring has fewer than 3 different points");
  EXPECT_EQ(find_flaw(polygon({}))->reason, "ring has fewer than 3 different points");
  EXPECT_EQ(find_flaw(polygon({{0, 0}, {1, 1}, {3, 3}, {2, 2}}))->reason, "ring has no area");
  EXPECT_EQ(find_flaw(polygon(square(0, 0, 4), {square(9, 9, 1)}))->reason, "hole lies outside its polygon");
  EXPECT_EQ(find_flaw(polygon(square(0, 0, 4), {square(4, 1, 1)}))->reason, "hole lies outside its polygon");
  EXPECT_EQ(find_flaw(polygon(square(0, 0, 4), {square(3.5, 1, 1)}))->reason, "edges cross");
  EXPECT_EQ(find_flaw(polygon(square(0, 0, 4), {square(1, 1, 1), square(1.5, 1.5, 1)}))->reason, "edges cross");
}

TEST(FindFlaw, TouchingIsNoFlaw) {
  EXPECT_FALSE(find_flaw(Region{}));
  EXPECT_FALSE(find_flaw(polygon(square(0, 0, 4), {square(0, 1, 1)})));
  EXPECT_FALSE(find_flaw(polygon(square(0, 0, 4), {square(0, 0, 4)})));
  EXPECT_FALSE(find_flaw(polygon(square(0, 0, 4), {square(1, 1, 1), square(2, 1, 1), square(2, 2, 1)})));
  EXPECT_FALSE(find_flaw(polygon(square(0, 0, 2), {{{0, 1}, {1, 2}, {2, 1}, {1, 0}}})));  // corners on the border
  EXPECT_FALSE(find_flaw(polygon({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}})));     // meets itself in a point
}

// Any two edges of random chains: the index against trying all pairs.
TEST(FindFlaw, FindsWhatAllPairsFind) {
  Rng rng(41);
  int flawed = 0;
  for (int round = 0; round < 300; ++round) {
    Ring ring = samples::star(rng, {0, 0}, 0.3, 1, 40);
    if (rng.chance(0.7)) std::swap(ring[rng.below(40)], ring[rng.below(40)]);
    bool crosses = false;
    for (std::size_t i = 0; i < 40; ++i)
      for (std::size_t j = i + 2; j < 40; ++j) {
        const Point a = ring[i], b = ring[i + 1], c = ring[j], d = ring[(j + 1) % 40];
        crosses =
            crosses || (cross(b - a, c - a) * cross(b - a, d - a) < 0 && cross(d - c, a - c) * cross(d - c, b - c) < 0);
      }
    const auto flaw = find_flaw(polygon(ring));
    EXPECT_EQ(flaw.has_value(), crosses);
    if (flaw) { EXPECT_LT(samples::distance_to_boundary(polygon(ring), flaw->point), 1e-12); }
    flawed += crosses ? 1 : 0;
  }
  EXPECT_GT(flawed, 50);
}

TEST(Repaired, SoundRegionsKeepEveryBit) {
  Rng rng(42);
  for (int round = 0; round < 30; ++round) expect_fixed(samples::holed_star(rng, {rng.between(-1e6, 1e6), 0.1}, 3));
  expect_fixed(polygon(square(0.1, 0.2, 1e-3)));
  expect_fixed(polygon({{0, 0}, {1e3, 0.1}, {1e3, 0.2}}));  // a needle
}

TEST(Repaired, OrientsAndCleans) {
  // wrong orientation, doubled points, a spike, points in line
  const Region r = repaired(
      polygon(reversed({{0, 0}, {0, 0}, {1, 0}, {2, 0}, {2, -5}, {2, 0}, {4, 0}, {4, 4}, {4, 4}, {0, 4}, {0, 2}}),
              {square(1, 1, 1)}));
  ASSERT_EQ(r.polygons.size(), 1u);
  EXPECT_EQ(r.polygons[0].outer.size(), 4u);
  EXPECT_EQ(signed_area(r.polygons[0].outer), 16);
  EXPECT_EQ(signed_area(r.polygons[0].holes.at(0)), -1);
  expect_fixed(r);
}

TEST(Repaired, ALineOfTenThousandCornersIsOneEdge) {
  Ring ring;
  for (int k = 0; k < 10000; ++k) ring.push_back({k * 0.25, 0});
  ring.push_back({0, 7});
  const Region r = repaired(polygon(ring));
  EXPECT_EQ(vertex_count(r), 3u);
  EXPECT_EQ(area(r), 9999 * 0.25 * 7 / 2);
}

TEST(Repaired, HolesThatTouchAreUnitedOrCutOut) {
  const Region shared = repaired(polygon(square(0, 0, 8), {square(1, 1, 1), square(2, 1, 1), square(5, 5, 1)}));
  EXPECT_EQ(hole_count(shared), 2u);
  EXPECT_NEAR(area(shared), 61, 1e-6);
  const Region border = repaired(polygon(square(0, 0, 8), {square(0, 1, 1)}));
  EXPECT_EQ(hole_count(border), 0u);
  EXPECT_NEAR(area(border), 63, 1e-6);
  const Region split = repaired(polygon(square(0, 0, 8), {{{3, 0}, {4, 0}, {4, 8}, {3, 8}}}));
  EXPECT_EQ(split.polygons.size(), 2u);
  EXPECT_NEAR(area(split), 56, 1e-6);
  const Region nested = repaired(polygon(square(0, 0, 8), {square(1, 1, 4), square(2, 2, 1)}));
  EXPECT_EQ(hole_count(nested), 1u);
  EXPECT_NEAR(area(nested), 48, 1e-6);
  EXPECT_TRUE(repaired(polygon(square(0, 0, 8), {square(0, 0, 8)})).empty());
  for (const Region& r : {shared, border, split, nested}) expect_fixed(r);
}

TEST(Repaired, OverlappingAndNestedPolygonsAreOne) {
  Region r = polygon(square(0, 0, 4));
  r.polygons.push_back({square(4, 0, 4), {}});  // a shared wall
  r.polygons.push_back({square(1, 1, 1), {}});  // inside the first
  const Region u = repaired(r);
  ASSERT_EQ(u.polygons.size(), 1u);
  EXPECT_EQ(u.polygons[0].outer.size(), 4u);
  EXPECT_NEAR(area(u), 32, 1e-6);
}

TEST(Repaired, IslandsInHolesStay) {
  Region r = polygon(square(0, 0, 9), {reversed(square(1, 1, 7))});
  r.polygons.push_back({square(2, 2, 5), {reversed(square(3, 3, 3))}});
  r.polygons.push_back({square(4, 4, 1), {}});
  expect_fixed(r);
  r.polygons[0].holes.push_back(square(0, 0, 1));  // something to mend elsewhere
  const Region mended = repaired(r);
  EXPECT_EQ(mended.polygons.size(), 3u);
  EXPECT_NEAR(area(mended), 81 - 49 + 25 - 9 + 1 - 1, 1e-6);
}

TEST(Repaired, RingsThatMeetThemselvesAreTakenApart) {
  // runs through itself at (1, 1): both halves belong to it
  const Region eight = repaired(polygon({{0, 0}, {1, 1}, {2, 2.5}, {2, 0}, {1, 1}, {0, 2}}));
  EXPECT_EQ(eight.polygons.size(), 2u);
  EXPECT_NEAR(area(eight), 2.25, 1e-7);
  const Region hour = repaired(polygon({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}}));
  EXPECT_EQ(hour.polygons.size(), 2u);
  EXPECT_NEAR(area(hour), 2, 1e-7);
  // a hole joined to the border by a bridge of no width
  const Region bridged = repaired(
      polygon({{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 4}, {3, 4}, {3, 6}, {6, 6}, {6, 3}, {3, 3}, {3, 4}, {0, 4}}));
  EXPECT_EQ(hole_count(bridged), 1u);
  EXPECT_NEAR(area(bridged), 72, 1e-6);
  expect_fixed(hour);
  expect_fixed(bridged);
}

TEST(Repaired, WorksFarOutAndVerySmall) {
  for (const double scale : {1e-3, 1.0, 1e3})
    for (const double far : {0.0, 1e6}) {
      const Region shape = polygon(square(0, 0, 8), {square(0, 1, 1), square(4, 4, 1), square(4, 5, 1)});
      Region r = shape;
      for (Polygon& p : r.polygons) {
        for (Point& q : p.outer) q = q * scale + Point(far, far);
        for (Ring& h : p.holes)
          for (Point& q : h) q = q * scale + Point(far, far);
      }
      const Region mended = repaired(r);
      EXPECT_NEAR(area(mended) / (scale * scale), 61, 1e-3) << scale << ' ' << far;
      expect_fixed(mended);
    }
}

TEST(Repaired, RefusesInOneSentence) {
  EXPECT_THAT(
      [] {
        repaired(polygon({{0, 0}, {2, 2}, {2, 0}, {0, 2}}));
      },
      testing::ThrowsMessage<std::invalid_argument>(
          "edges cross at (1, 1); expected polygons whose edges do not cross, with holes inside them"));
}

TEST(Repaired, AnswersWithSoundRegionsWhateverTheTouching) {
  Rng rng(43);
  for (int round = 0; round < 100; ++round) {  // boxes on a coarse lattice: every kind of touching, no crossing
    Region r = polygon(square(0, 0, 8));
    double removed = 0;
    BitGrid cells({0, 0}, 1, 8, 8);
    for (int k = 0; k < 12; ++k) {
      const int i = rng.between(0, 7), j = rng.between(0, 7);
      r.polygons[0].holes.push_back(square(i, j, 1));
      if (!cells.get(i, j)) removed += 1;
      cells.set(i, j, true);
    }
    const Region mended = repaired(r);
    EXPECT_NEAR(area(mended), 64 - removed, 1e-6);
    EXPECT_FALSE(find_flaw(mended));
    expect_fixed(mended);
  }
}

}  // namespace
}  // namespace oxturn
