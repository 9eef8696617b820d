#include "geometry/overlay/cut_along.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "geometry/edge_index.hpp"
#include "random_region.hpp"

namespace oxturn {
namespace {

const Region kBox = box_region({0, 0}, {10, 10});

TEST(CutAlong, NoLinesLeaveTheRegion) {
  EXPECT_EQ(area(cut_along(kBox, {}, 0.1)), 100);
  EXPECT_TRUE(cut_along(Region{}, {{{0, 0}, {1, 1}}}, 0.1).empty());
}

TEST(CutAlong, AStripReachesHalfItsWidthPastItsEnds) {
  const Region r = cut_along(kBox, {{{2, 5}, {8, 5}}}, 0.5);
  ASSERT_EQ(r.polygons.size(), 1u);
  ASSERT_EQ(hole_count(r), 1u);
  EXPECT_NEAR(area(r), 100 - 6.5 * 0.5, 1e-6);
}

TEST(CutAlong, WallToWallCutsInTwoWhateverTheDirection) {
  for (int k = 0; k < 60; ++k) {
    const double angle = 0.1 * k;
    const Point d(std::cos(angle), std::sin(angle));
    // To the walls exactly, rounded: the ends may lie a little inside.
    const double far = 5 / std::max(std::abs(d.x()), std::abs(d.y()));
    const Region r = cut_along(kBox, {{Point(5, 5) - far * d, Point(5, 5) + far * d}}, 1e-5);
    EXPECT_EQ(r.polygons.size(), 2u) << angle;
    EXPECT_NEAR(area(r), 100, 1e-3);
  }
}

TEST(CutAlong, StripsThatShareAPointLeaveNoGap) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Rng rng(seed);
    const Point hub(rng.between(2.0, 8.0), rng.between(2.0, 8.0));
    const int spokes = rng.between(2, 7);
    std::vector<Polyline> lines;
    for (int k = 0; k < spokes; ++k) {  // a bent spoke each, out of the box
      const double angle = 2 * kPi * (k + 0.5 * rng.unit()) / spokes;
      const Point bend = hub + rng.between(0.2, 1.0) * Point(std::cos(angle), std::sin(angle));
      const double turn = angle + rng.between(-0.3, 0.3) / spokes;
      lines.push_back({hub, bend, bend + 20 * Point(std::cos(turn), std::sin(turn))});
      if (rng.chance(0.5)) std::reverse(lines.back().begin(), lines.back().end());
      if (rng.chance(0.3)) lines.push_back(lines.back());  // repeated
    }
    const Region r = cut_along(kBox, lines, 1e-4);
    EXPECT_EQ(r.polygons.size(), static_cast<std::size_t>(spokes));
    EXPECT_EQ(hole_count(r), 0u);
  }
}

// Each small bend had a step on either side, where two rectangles overlapped.
TEST(CutAlong, StripsOfLinesThatBendALittleHaveNoSteps) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    const double width = rng.between(0.01, 0.3), most = rng.between(0.01, 0.45);
    Polyline line{{-1, 5}};
    while (line.back().x() < 11) {
      const double turn = rng.between(-most, most);
      line.push_back(line.back() + rng.between(2 * width, 1.0) * Point(std::cos(turn), std::sin(turn)));
    }
    const Region r = cut_along(kBox, {line}, width);
    EXPECT_EQ(r.polygons.size(), 2u);
    EXPECT_LE(vertex_count(r), 2 * line.size() + 8);
    for_each_edge(r, [&](const Point& a, const Point& b) {  // every vertex is a mitre's end or on the box
      const bool on_box = std::min(std::min(a.x(), a.y()), std::min(10 - a.x(), 10 - a.y())) < 1e-6;
      double nearest = 1e300;
      for (const Point& p : line) nearest = std::min(nearest, distance(a, p));
      EXPECT_TRUE(on_box || nearest < width / 2 / std::cos(most) + 1e-6) << a << ' ' << b;
    });
  }
}

TEST(CutAlong, WhatIsTakenAwayIsWithinTheWidthOfTheLines) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Rng rng(seed);
    const Region region = clutter_box(rng, 3, 3, false);
    Polyline line;
    for (int k = 0; k < 6; ++k) line.push_back({rng.between(-0.5, 3.5), rng.between(-0.5, 3.5)});
    const double width = 0.05;
    const Region r = cut_along(region, {line}, width);
    const EdgeIndex before(region), after(r);
    for (int q = 0; q < 200; ++q) {
      Point p(rng.between(0.0, 3.0), rng.between(0.0, 3.0));
      if (q % 2 == 0)
        p = lerp(line[0], line[1], rng.unit()) + Point(rng.between(-0.05, 0.05), rng.between(-0.05, 0.05));
      double d = 1e300;
      for (std::size_t i = 1; i < line.size(); ++i) d = std::min(d, distance_to_segment(p, line[i - 1], line[i]));
      if (!before.contains(p)) {
        EXPECT_FALSE(after.contains(p) && after.nearest(p)->distance > 1e-6);
      } else if (d < width / 2 - 1e-6) {
        EXPECT_FALSE(after.contains(p));
      } else if (d > width / std::sqrt(2.0) + 1e-6) {  // a rectangle's corner
        EXPECT_TRUE(after.contains(p) || after.nearest(p)->distance < 1e-6);
      }
    }
  }
}

TEST(CutAlong, RefusesWhatItCannotCut) {
  using testing::HasSubstr;
  using testing::ThrowsMessage;
  EXPECT_THAT(
      [] {
        cut_along(kBox, {{{0, 0}, {1, 1}}}, 1e-8);
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("too narrow")));
  EXPECT_THAT(
      [] {
        cut_along(kBox, {{{0, 0}, {1, 1}}}, std::nan(""));
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("too narrow")));
  EXPECT_THAT(
      [] {
        cut_along(kBox, {{{0, 0}, {std::nan(""), 1}}}, 0.1);
      },
      ThrowsMessage<std::invalid_argument>(HasSubstr("not finite")));
}

}  // namespace
}  // namespace oxturn
