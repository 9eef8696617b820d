#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "algorithms/transit/connector.hpp"
#include "tests/support/drawn.hpp"

namespace oxturn {
namespace {

TEST(Connector, GoesStraightWhereItCan) {
  const Problem p = drawn({"....", "....", "...."});
  const Connector c(p);
  EXPECT_TRUE(c.straight({0.5, 0.5}, {3.5, 2.5}));
  EXPECT_EQ(c.path({0.5, 0.5}, {3.5, 2.5}).size(), 2u);
  EXPECT_DOUBLE_EQ(c.length({0.5, 0.5}, {3.5, 0.5}), 3);
}

// Round the end of a wall 1 m thick with a robot of 0.2: tangents and an arc, by hand.
TEST(Connector, GoesRoundTheEndOfAWall) {
  const Problem p = drawn({"S....", ".....", "..#..", "..#..", "..#.."});
  const Connector c(p);
  const Point a(1.5, 0.5), b(3.5, 0.5);
  EXPECT_FALSE(c.straight(a, b));
  // From a to the corner's arc about (2, 3): distance sqrt(.5^2 + 2.5^2), tangent, arc, 1 m along, and the mirror image.
  const double d = std::hypot(0.5, 2.5), r = 0.2;
  const double tangent = std::sqrt(d * d - r * r);
  const double turn = std::atan2(2.5, 0.5) + std::asin(r / d);
  EXPECT_NEAR(c.length(a, b), 2 * (tangent + r * turn) + 1, 2e-3);
  EXPECT_NEAR(length(c.path(a, b)), c.length(a, b), 1e-12);
  EXPECT_EQ(c.length(a, b, 3), std::numeric_limits<double>::infinity());
}

TEST(Connector, APlaceInAWallIsOneSentence) {
  const Problem p = drawn({"S#."});
  const Connector c(p);
  EXPECT_THAT(
      [&] {
        c.path({0.5, 0.5}, {2.5, 0.5});
      },
      testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("no way from (0.5, 0.5) to (2.5, 0.5)")));
}

}  // namespace
}  // namespace oxturn
