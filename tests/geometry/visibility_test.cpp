#include "geometry/paths/visibility.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "geometry/edge_index.hpp"
#include "geometry/overlay/boolean.hpp"
#include "random_region.hpp"
#include "samples.hpp"
#include "tests/support/drawn.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

/// Area of what is seen: many rays, each against all edges. Knows nothing of triangles. `reach`: of the region.
double area_by_rays(const Region& region, const Point& eye, int rays) {
  double sum = 0;
  for (int k = 0; k < rays; ++k) {
    const double angle = 2 * kPi * (k + 0.437) / rays;
    const Point u(std::cos(angle), std::sin(angle));
    if (!samples::sees_all_round(region, eye + 1e-6 * u)) continue;  // into a wall that the eye lies on
    double nearest = 1e300;
    for_each_ring(region, [&](const Ring& r) {
      for (std::size_t i = 0, j = r.size() - 1; i < r.size(); j = i++) {
        const Point d = r[i] - r[j], w = r[j] - eye;
        const double den = cross(u, d);
        if (den == 0) continue;
        const double t = cross(w, d) / den, s = cross(w, u) / den;
        if (s >= 0 && s <= 1 && t > 1e-6 && t < nearest) nearest = t;
      }
    });
    sum += nearest * nearest * kPi / rays;
  }
  return sum;
}

Point free_point(Rng& rng, const EdgeIndex& index, const Box& box) {
  while (true) {
    const Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
    if (index.contains(p)) return p;
  }
}

/// Eyes in the open, on walls, at corners, each against points drawn at random.
void compare(const Region& region, Rng& rng, int eyes, int points) {
  const EdgeIndex index(region);
  const Visibility visibility(region);
  const Box box = bounding_box(region);
  for (int k = 0; k < eyes; ++k) {
    const EdgeIndex::Edge& e = index.edges()[rng.below(index.edges().size())];
    Point eye = k % 3 == 0 ? free_point(rng, index, box) : k % 3 == 1 ? e.a : Point((e.a + e.b) / 2);
    if (!index.contains(eye)) continue;  // a rounded middle of an edge may lie outside by 1e-16
    SCOPED_TRACE(testing::Message() << "eye " << eye.transpose());
    const Region seen{{{visibility.from(eye), {}}}};
    ASSERT_GE(seen.polygons[0].outer.size(), 3u);
    for (int q = 0; q < points; ++q) {
      const Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
      if (samples::distance_to_boundary(seen, p) < 1e-9) continue;
      const bool sees = index.contains(eye, p);
      EXPECT_EQ(samples::sees_all_round(seen, p), sees) << p.transpose();
    }
    EXPECT_NEAR(area(seen), area_by_rays(region, eye, 2000), 0.02 * area(seen) + 1e-3 * area(region));
    EXPECT_TRUE(k % 3 != 0 || samples::sees_all_round(seen, eye));
  }
}

/// The triangle at the eye between two directions, with a far side beyond the region.
Region wedge(const Point& eye, const Visibility::ViewSector& sector, double far) {
  const Point right = sector.right.normalized(), left = sector.left.normalized();
  const double away = far / std::sqrt((1 + right.dot(left)) / 2);  // so that the far side is `far` away
  return {{{{eye, eye + away * right, eye + away * left}, {}}}};
}

TEST(Visibility, InASectorSeesThatPartOfTheWhole) {
  std::size_t nothing = 0, something = 0;
  for (const auto seed : seeds(40)) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    const Region region = clutter_box(rng, rng.between(1, 4), rng.between(1, 4), seed % 2 == 0);
    const EdgeIndex index(region);
    const Visibility visibility(region);
    const Box box = bounding_box(region);
    for (int k = 0; k < 12; ++k) {
      const Point eye = k % 3 == 0 ? free_point(rng, index, box) : index.edges()[rng.below(index.edges().size())].a;
      const double begin = rng.between(0.0, 2 * kPi), width = rng.between(0.01, 3.0);
      const Visibility::ViewSector sector{2 * rotated({1, 0}, begin), 0.5 * rotated({1, 0}, begin + width)};
      SCOPED_TRACE(testing::Message() << "eye " << eye.transpose() << ", from " << begin << " by " << width);
      std::vector<std::int32_t> near, near_all;
      const Ring part = visibility.from(eye, sector, 0, &near), all = visibility.from(eye, 0, &near_all);
      EXPECT_TRUE(std::ranges::includes(near_all, near));
      EXPECT_EQ(part.front(), eye);
      const double expected = area(intersect({{{all, {}}}}, wedge(eye, sector, 2 * box.size().norm())));
      EXPECT_NEAR(part.size() < 3 ? 0 : signed_area(part), expected, 1e-6);
      ++(expected > 0 ? something : nothing);
    }
  }
  EXPECT_GT(something, 300u);
  EXPECT_GT(nothing, 20u);
}

TEST(Visibility, SeesWhatSegmentsReachAmongConvexHoles) {
  for (const auto seed : seeds(30)) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    compare(clutter_box(rng, rng.between(1, 4), rng.between(1, 4), false), rng, 6, 100);
  }
}

TEST(Visibility, SeesWhatSegmentsReachOnALattice) {  // collinear corners and eyes in line with walls everywhere
  for (const auto seed : seeds(30)) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    compare(clutter_box(rng, rng.between(1, 4), rng.between(1, 4), true), rng, 6, 100);
  }
}

TEST(Visibility, SeesWhatSegmentsReachInStars) {
  for (const auto seed : seeds(30)) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    compare(star_region(rng, rng.between(5, 40)), rng, 6, 100);
  }
}

TEST(Visibility, SeesWhatSegmentsReachWhereRingsTouch) {  // traced cells: corners that touch diagonally
  for (const auto seed : seeds(20)) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    const Region all = trace(samples::speckled(rng, 10, 0.5, 14, 2));
    if (!all.empty()) compare(all, rng, 6, 100);
  }
}

TEST(Visibility, AnEmptyRoomIsItsOwnRing) {
  const Ring room{{0, 0}, {4, 0}, {5, 3}, {0, 2}};
  Ring seen = Visibility(Region{{{room, {}}}}).from({1, 1});
  std::rotate(seen.begin(), std::find(seen.begin(), seen.end(), Point(0, 0)), seen.end());
  EXPECT_EQ(seen, room);
}

TEST(Visibility, CornersInLineDoNotBlock) {
  // Two teeth extend down to y = 2, where the eye looks along: all below, and the first bay above.
  const Region comb{
      {{{{0, 0}, {10, 0}, {10, 4}, {6, 4}, {6, 2}, {5, 2}, {5, 4}, {3, 4}, {3, 2}, {2, 2}, {2, 4}, {0, 4}}, {}}}};
  const Ring seen = Visibility(comb).from({0, 2});
  EXPECT_DOUBLE_EQ(signed_area(seen), 24);
  for (const Point& p : {Point(2, 2), Point(10, 2)}) EXPECT_EQ(std::count(seen.begin(), seen.end(), p), 1) << p;
}

TEST(Visibility, RaysEndOnTheFarWall) {
  // One pillar; its shadow on the far wall begins where the rays past (2, 1) and (2, 2) meet x = 6.
  const Region room{{{{{0, 0}, {6, 0}, {6, 3}, {0, 3}}, {{{2, 1}, {2, 2}, {3, 2}, {3, 1}}}}}};
  const Ring seen = Visibility(room).from({0, 1.5});
  // Blocked: from x = 2 on, |y - 1.5| < x / 4, out to x = 6.
  EXPECT_NEAR(signed_area(seen), 18 - (6 * 6 - 2 * 2) / 4.0, 1e-12);
}

TEST(Visibility, AnEyeWherePartsTouchSeesBoth) {
  Region parts{{{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}}, {{{1, 1}, {3, 1}, {3, 2}, {1, 2}}, {}}}};
  const Visibility visibility(parts);
  EXPECT_DOUBLE_EQ(signed_area(visibility.from({1, 1})), 3);
  EXPECT_DOUBLE_EQ(signed_area(visibility.from({0.5, 0.5})), 1);
}

TEST(Visibility, ScalesTurnsAndShiftsWithTheRegion) {
  Rng rng(5);
  const Region region = clutter_box(rng, 4, 3, false);
  const Point eye = free_point(rng, EdgeIndex(region), bounding_box(region));
  const double seen = signed_area(Visibility(region).from(eye));
  for (const double angle : {0.3, 1.7, 4.0}) {
    const Point shift(1e4, -2e3);
    EXPECT_NEAR(signed_area(Visibility(transformed(region, angle, shift)).from(rotated(eye, angle) + shift)), seen,
                1e-6);
  }
}

TEST(Visibility, AnEyeOutsideIsASentenceUnlessItIsOnlyJustOutside) {
  const Visibility room(box_region({0, 0}, {2, 1}));
  EXPECT_THAT(
      [&] {
        room.from({2.5, 0.5}, 0.1);
      },
      testing::ThrowsMessage<std::invalid_argument>(testing::HasSubstr("eye (2.5, 0.5) is outside")));
  EXPECT_THROW(room.from({std::nan(""), 0.5}, 1), std::invalid_argument);
  EXPECT_THROW(Visibility(Region{}).from({0, 0}, 1), std::invalid_argument);
  EXPECT_DOUBLE_EQ(signed_area(room.from({2.0001, 0.5}, 1e-3)), 2);
  EXPECT_DOUBLE_EQ(signed_area(room.from({-0.0001, -0.0001}, 1e-3)), 2);
}

}  // namespace
}  // namespace oxturn
