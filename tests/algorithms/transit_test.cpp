#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/transit/connector.hpp"
#include "tests/support/drawn.hpp"

namespace oxturn {
namespace {

TEST(Connector, GoesStraightWherePossible) {
  const Problem p = drawn({"....", "....", "...."});
  const Connector c(p);
  EXPECT_TRUE(c.straight({0.5, 0.5}, {3.5, 2.5}));
  EXPECT_EQ(c.path({0.5, 0.5}, {3.5, 2.5}).size(), 2u);
  EXPECT_DOUBLE_EQ(c.length({0.5, 0.5}, {3.5, 0.5}), 3);
}

// Around the end of a wall 1 m thick with a robot of 0.2 m. Oracle: tangents and arcs.
TEST(Connector, GoesAroundTheEndOfAWall) {
  const Problem p = drawn({"S....", ".....", "..#..", "..#..", "..#.."});
  const Connector c(p);
  const Point a(1.5, 0.5), b(3.5, 0.5);
  EXPECT_FALSE(c.straight(a, b));
  // From a to the arc around (2, 3), the corner of the wall: a tangent and the arc; 1 m along the wall; the mirror
  // image.
  const double d = std::hypot(0.5, 2.5), r = 0.2;
  const double tangent = std::sqrt(d * d - r * r);
  const double turn = std::atan2(2.5, 0.5) + std::asin(r / d);
  EXPECT_NEAR(c.length(a, b), 2 * (tangent + r * turn) + 1, 2e-3);
  EXPECT_NEAR(length(c.path(a, b)), c.length(a, b), 1e-12);
  EXPECT_EQ(c.length(a, b, 3), std::numeric_limits<double>::infinity());
}

TEST(Connector, PointsThatAreNotConnectedAreOneSentence) {
  const Problem p = drawn({"S#."});
  const Connector c(p);
  EXPECT_THAT(
      [&] {
        c.path({0.5, 0.5}, {2.5, 0.5});
      },
      testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("no path from (0.5, 0.5) to (2.5, 0.5)")));
}

}  // namespace
}  // namespace oxturn
