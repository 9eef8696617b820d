#include "algorithms/drawing/fill_order.hpp"

#include <gtest/gtest.h>

namespace oxturn {
namespace {

Leg lap(double inset) {
  const double a = inset, b = 10 - inset;
  return {.tool = true, .points = {{a, a}, {b, a}, {b, b}, {a, b}, {a, a}}, .width = 1};
}

DrawingElement laps(const std::vector<double>& insets) {
  DrawingElement element{
      .name = "area", .legs = {}, .area = std::make_shared<const Ring>(Ring{{0, 0}, {10, 0}, {10, 10}, {0, 10}})};
  for (const double inset : insets) {
    if (!element.legs.empty()) element.legs.push_back({false, {element.legs.back().points.back(), {inset, inset}}});
    element.legs.push_back(lap(inset));
  }
  return element;
}

/// How often a lap comes after one that lies outside of it.
InnerPrice inwards(const DrawingElement& element) {
  double count = 0;
  for (std::size_t k = 2; k < element.legs.size(); k += 2)
    count += element.legs[k].points[0].x() > element.legs[k - 2].points[0].x();
  return {count, 0};
}

TEST(FillOrder, LapsFromTheInsideToTheOutside) {
  for (const auto& insets : std::vector<std::vector<double>>{{0.5, 1.5, 2.5, 3.5}, {2.5, 0.5, 3.5, 1.5}}) {
    const DrawingElement best = best_order(laps(insets), 1, inwards);
    ASSERT_EQ(best.legs.size(), 7u);
    EXPECT_EQ(inwards(best).first, 0);
    EXPECT_TRUE(best.one_way);
    for (std::size_t k = 0; k < best.legs.size(); ++k) {
      EXPECT_EQ(best.legs[k].tool, k % 2 == 0);
      if (k > 0) { EXPECT_EQ(best.legs[k].points.front(), best.legs[k - 1].points.back()); }
    }
  }
}

TEST(FillOrder, WhatCrossesNothingStays) {
  const DrawingElement planned = laps({3.5, 2.5});
  const DrawingElement best = best_order(planned, 1, [](const DrawingElement&) { return InnerPrice{0, 5}; });
  EXPECT_EQ(best.legs[0].points, planned.legs[0].points);
  EXPECT_EQ(best.legs[2].points, planned.legs[2].points);
  EXPECT_FALSE(best.one_way);
}

}  // namespace
}  // namespace oxturn
