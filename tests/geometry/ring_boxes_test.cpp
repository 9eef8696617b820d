// Rings found by their boxes, and squares around segments.
#include "geometry/ring_boxes.hpp"

#include <gtest/gtest.h>

#include "geometry/edge_index.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/raster.hpp"
#include "tests/support/maps.hpp"
#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

Region box_at(double x, double y, double side) {
  return {{{{{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}}, {}}}};
}

TEST(RingBoxes, WhatIsNearIsTheRegionInTheBox) {
  for (const auto seed : seeds(3)) {
    const Region region = generate("clutter", {{"width", 20.0}, {"height", 20.0}}, seed).free;
    const RingBoxes rings(region);
    for (const double x : {-1.0, 3.0, 11.5}) {
      const Region window = box_at(x, 4, 5);
      const Region near = rings.near(bounding_box(window));
      EXPECT_NEAR(area(intersect(near, window)), area(intersect(region, window)), 1e-9);
      EXPECT_LT(vertex_count(near), vertex_count(region));
    }
    EXPECT_TRUE(rings.near(bounding_box(box_at(50, 50, 1))).empty());
  }
}

TEST(RingBoxes, ClippedIsTheRegionInTheBoxWithFewerVertices) {
  for (const auto seed : seeds(3)) {
    const Region region = generate("cave", {{"width", 20.0}, {"height", 20.0}}, seed).free;
    for (const double x : {-1.0, 3.0, 11.5}) {
      const Region window = box_at(x, 4, 5);
      Box around = bounding_box(window);
      around.grow(0.5);
      const Region there = clipped(region, around);
      EXPECT_NEAR(area(intersect(there, window)), area(intersect(region, window)), 1e-6);
      EXPECT_NEAR(area(subtract(window, there)), area(subtract(window, region)), 1e-6);
      std::size_t outer = 0, all = 0;
      for (const Polygon& polygon : there.polygons) outer += polygon.outer.size();
      for (const Polygon& polygon : region.polygons) all += polygon.outer.size();
      EXPECT_LT(outer, all / 2);
    }
    EXPECT_TRUE(clipped(region, bounding_box(box_at(50, 50, 1))).empty());
  }
}

TEST(BoxIndex, FindsTheBoxesThatOverlap) {
  std::vector<Box> boxes;
  for (int i = 0; i < 40; ++i) boxes.push_back(bounding_box(box_at(i % 8 * 1.5, i / 8 * 1.5, 1 + i % 3)));
  const BoxIndex index(boxes);
  for (const double at : {-3.0, 0.7, 2.2, 6.0, 30.0}) {
    const Box query = bounding_box(box_at(at, at / 2, 2));
    std::vector<std::uint32_t> expected;
    for (std::uint32_t i = 0; i < boxes.size(); ++i)
      if (boxes[i].overlaps(query)) expected.push_back(i);
    EXPECT_EQ(index.overlapping(query), expected);
  }
}

TEST(SquaresAround, HoldTheReachOfTheSegmentsAndLittleMore) {
  const std::vector<Polyline> segments{{{0, 0}, {3, 1}}, {{7, 2}, {7, 2.1}}};
  const double reach = 0.8, cell = 0.25;
  const Region squares = squares_around(segments, reach, cell);
  const EdgeIndex edges(squares);
  for (double x = -2; x < 10; x += 0.13)
    for (double y = -2; y < 5; y += 0.11) {
      double away = 1e9;
      for (const Polyline& s : segments) away = std::min(away, distance_to_segment({x, y}, s[0], s[1]));
      if (away <= reach) { EXPECT_TRUE(edges.contains(Point(x, y))) << x << " " << y; }
      if (away > 1.5 * (reach + 3 * cell)) { EXPECT_FALSE(edges.contains(Point(x, y))) << x << " " << y; }
    }
}

}  // namespace
}  // namespace oxturn
