#include "algorithms/drawing/outline_last.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace oxturn {
namespace {

const Ring kOuter{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
bool anywhere(const Point&, const Point&) { return true; }

/// From the middle to the lap inside the outermost one, that one as a detour from (1, 5), and on to `to`.
std::vector<Leg> with_detour(const Point& to) {
  return {{true, {{5, 5}, {1, 5}, {0, 5}, {0, 10}, {10, 10}, {10, 0}, {0, 0}, {0, 5}, {1, 5}, to}}};
}

TEST(OutlineLast, TheLapAlongTheBoundaryIsDrivenAtTheNearerEnd) {
  const std::vector<Leg> legs = with_detour({1, 1});
  const std::vector<Leg> changed = outline_last(legs, kOuter, 1, anywhere);
  ASSERT_EQ(changed.size(), 1u);
  const Polyline& line = changed[0].points;
  EXPECT_EQ(line.front(), Point(5, 5));
  EXPECT_TRUE(line.back() == Point(0, 1) || line.back() == Point(1, 0));
  EXPECT_NEAR(length(line), length(legs[0].points) + 1, 1e-9);  // and the connection
  // Of the reversed fill it comes first.
  std::vector<Leg> reversed = legs;
  std::reverse(reversed[0].points.begin(), reversed[0].points.end());
  const Polyline first = outline_last(reversed, kOuter, 1, anywhere)[0].points;
  EXPECT_EQ(first.back(), Point(5, 5));
  EXPECT_TRUE(first.front() == Point(0, 1) || first.front() == Point(1, 0));
}

TEST(OutlineLast, NothingChangesWhereTheLapIsOutOfReach) {
  for (const double end : {1.0, 5.0}) {
    const std::vector<Leg> legs = with_detour({end, end});
    const auto free = [&](const Point&, const Point&) { return end > 1; };
    EXPECT_EQ(outline_last(legs, kOuter, 1, free)[0].points, legs[0].points);
  }
}

TEST(OutlineLast, NothingChangesWithoutALapAlongTheBoundary) {
  const std::vector<Leg> legs{{true, {{5, 5}, {1, 5}, {2, 8}, {1, 5}, {1, 1}}}};
  EXPECT_EQ(outline_last(legs, kOuter, 1, anywhere)[0].points, legs[0].points);
}

}  // namespace
}  // namespace oxturn
