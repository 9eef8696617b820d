#include <gtest/gtest.h>

#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/validity.hpp"
#include "geometry/raster.hpp"
#include "tests/geometry/samples.hpp"

namespace oxturn {
namespace {

void expect_promises(const Region& old, double tolerance) {
  const Region now = simplify_inward(old, tolerance);
  EXPECT_LE(area(now), area(old) + 1e-12);
  EXPECT_LE(vertex_count(now), vertex_count(old));
  EXPECT_LT(area(subtract(now, old)), 1e-7 * (1 + perimeter(old)));
  EXPECT_FALSE(find_flaw(now));
  ASSERT_EQ(now.polygons.size(), old.polygons.size());
  for (std::size_t k = 0; k < old.polygons.size(); ++k) {
    ASSERT_EQ(now.polygons[k].holes.size(), old.polygons[k].holes.size());
    const auto near = [&](const Ring& before, const Ring& after) {
      EXPECT_GE(after.size(), 3u);
      for (const Point& p : before)
        EXPECT_LE(samples::distance_to_boundary({{Polygon{after, {}}}}, p), tolerance + 1e-12) << p.transpose();
    };
    near(old.polygons[k].outer, now.polygons[k].outer);
    for (std::size_t h = 0; h < old.polygons[k].holes.size(); ++h)
      near(old.polygons[k].holes[h], now.polygons[k].holes[h]);
  }
}

TEST(SimplifyInward, KeepsItsPromises) {
  Rng rng(71);
  for (int round = 0; round < 15; ++round) {
    SCOPED_TRACE(round);
    expect_promises(samples::holed_star(rng, {0, 0}, 2), rng.between(0.0, 0.5));
    expect_promises(trace(samples::speckled(rng, 60, 0.05, 40, 8)), rng.between(0.0, 0.2));
  }
}

// Holes that do not meet the box may be missing: the other rings become the same, and never cross them.
TEST(SimplifyInward, InABoxNeedsOnlyTheHolesThere) {
  Rng rng(72);
  int removed = 0;
  for (int round = 0; round < 300; ++round) {
    SCOPED_TRACE(round);
    const Region whole =
        round % 2 == 0 ? samples::holed_star(rng, {0, 0}, 2) : trace(samples::speckled(rng, 60, 0.05, 40, 8));
    const Box all = bounding_box(whole);
    Box within;
    for (int k = 0; k < 2; ++k)
      within.add({rng.between(all.low.x(), all.high.x()), rng.between(all.low.y(), all.high.y())});
    const double tolerance = rng.between(0.0, 0.5);
    const Region now = simplify_inward(whole, tolerance, within);
    EXPECT_FALSE(find_flaw(now));
    EXPECT_LT(area(subtract(now, whole)), 1e-7 * (1 + perimeter(whole)));
    const Region lost = subtract(whole, now);
    EXPECT_LT(area(subtract(lost, box_region(within.low, within.high))), 1e-7 * (1 + perimeter(whole)));
    // Without the holes off the box: the same again.
    Region fewer = whole;
    for (Polygon& polygon : fewer.polygons)
      std::erase_if(polygon.holes, [&](const Ring& hole) { return !bounding_box(hole).overlaps(within); });
    EXPECT_LT(area(subtract(subtract(fewer, simplify_inward(fewer, tolerance, within)), lost)), 1e-9);
    removed += static_cast<int>(vertex_count(whole) - vertex_count(now));
  }
  EXPECT_GT(removed, 300);
}

TEST(SimplifyInward, ToleranceZeroDropsCollinearCornersOnly) {
  const Region r{{Polygon{{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {1, 1}, {0, 2}, {0, 1}}, {}}}};
  const Region s = simplify_inward(r, 0);
  EXPECT_EQ(s.polygons[0].outer.size(), 5u);
  EXPECT_EQ(area(s), area(r));
}

TEST(SimplifyInward, StairsBecomeRamps) {
  BitGrid stairs({0, 0}, 1, 300, 110);
  for (int j = 0; j < stairs.rows; ++j)
    for (int i = 0; i < stairs.columns; ++i) stairs.set(i, j, j < 5 + i / 3);
  const Region r = trace(stairs), s = simplify_inward(r, 1.0);
  EXPECT_GT(vertex_count(r), 190u);
  EXPECT_LT(vertex_count(s), 110u);  // each step's convex corner goes, its inner corner cannot
  BitGrid disc({0, 0}, 1, 101, 101);
  for (int j = 0; j < 101; ++j)
    for (int i = 0; i < 101; ++i) disc.set(i, j, std::hypot(i - 50, j - 50) < 50);
  const Region d = trace(disc), round = simplify_inward(d, 1.0);
  EXPECT_LT(vertex_count(round) * 2, vertex_count(d));
  expect_promises(d, 1.0);
  expect_promises(r, 1.0);
}

TEST(SimplifyInward, NeverLetsARingVanishOrMeetAnother) {
  // A thin sliver of free space between a hole and the border: corners that would cross it stay.
  const Region r{{Polygon{{{0, 0}, {4, 0}, {4, 4}, {2, 4.05}, {0, 4}}, {{{1, 3.98}, {3, 3.98}, {2, 4.03}}}}}};
  expect_promises(r, 0.5);
  const Region tiny = box_region({0, 0}, {0.1, 0.1});
  EXPECT_GE(simplify_inward(tiny, 5).polygons.at(0).outer.size(), 3u);
}

}  // namespace
}  // namespace oxturn
