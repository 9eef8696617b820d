#include "algorithms/drawing/loose_strokes.hpp"

#include <gtest/gtest.h>

#include "algorithms/drawing/priced_order.hpp"
#include "tests/support/drawings.hpp"

namespace oxturn {
namespace {

Leg stroke(Polyline points) { return {.tool = true, .points = std::move(points), .width = 0.42}; }

/// A fill of so many strokes upwards, one beside the other.
DrawingElement fill(const std::string& name, double x, int strokes) {
  DrawingElement e{
      .name = name, .legs = {}, .area = std::make_shared<const Ring>(Ring{{x, 2}, {x + 3, 2}, {x + 3, 8}, {x, 8}})};
  for (int k = 0; k < strokes; ++k, x += 0.42) {
    if (k > 0) e.legs.push_back({false, {e.legs.back().points.back(), {x, 3}}});
    e.legs.push_back(stroke({{x, 3}, {x, 7}}));
  }
  e.followed = true;
  return e;
}

TEST(LooseStrokes, DrawTheSameInTheSameOrder) {
  const std::vector<DrawingElement> whole{fill("a", 3, 3), fill("b", 8, 1), fill("c", 12, 2)};
  const LooseStrokes loose(whole, {.joined = {}, .deleted = {}, .contained = {{2, 0}}}, {});
  ASSERT_EQ(loose.elements.size(), 6u);
  EXPECT_EQ(loose.elements[2].name, "a");
  const ElementPieces before = pieces_of(whole), after = pieces_of(loose.elements);
  ASSERT_EQ(before.pieces.size(), after.pieces.size());
  for (std::size_t k = 0; k < before.pieces.size(); ++k) EXPECT_EQ(before.pieces[k].points, after.pieces[k].points);
  // Each stroke of c comes after each of a.
  EXPECT_EQ(loose.demands.contained.size(), 6u);

  std::vector<Polyline> lines;
  for (const ElementVisit& visit : loose.order({{2, 0, true}, {1, 0, false}, {0, 0, false}}))
    lines.push_back(driven(loose.elements[visit.element], visit)[0].points);
  const double x = 12 + 0.42;
  ASSERT_EQ(lines.size(), 6u);
  EXPECT_EQ(lines[0], (Polyline{{x, 7}, {x, 3}}));
  EXPECT_EQ(lines[2], (Polyline{{8, 3}, {8, 7}}));
  EXPECT_EQ(lines[3], (Polyline{{3, 3}, {3, 7}}));
}

TEST(LooseStrokes, WhatAPersonConnectsStaysWhole) {
  const std::vector<DrawingElement> whole{fill("a", 3, 3), fill("b", 8, 2), fill("c", 12, 2)};
  const std::pair<ElementPort, ElementPort> joint{{1, 1}, {2, 0}};
  const LooseStrokes loose(whole, {.joined = {joint}, .deleted = {}}, {{joint, {}}});
  ASSERT_EQ(loose.elements.size(), 5u);
  const std::pair<ElementPort, ElementPort> moved{{3, 1}, {4, 0}};
  ASSERT_EQ(loose.demands.joined.size(), 1u);
  EXPECT_EQ(loose.demands.joined[0], moved);
  EXPECT_EQ(loose.curves.count(moved), 1u);
}

}  // namespace
}  // namespace oxturn
