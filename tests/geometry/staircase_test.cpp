// Walls traced from images.
#include "geometry/staircase.hpp"

#include <gtest/gtest.h>

namespace oxturn {
namespace {

/// A square of side 10 whose lower side is a staircase there and back, in steps of `step`.
Region stairs(double step) {
  Ring ring{{10, 0}, {10, 10}, {0, 10}, {0, 0}};
  for (int k = 0; k < 10; ++k) {
    ring.push_back({step * k, -step * (k + 1)});
    ring.push_back({step * (k + 1), -step * (k + 1)});
  }
  return {{{ring, {}}}};
}

TEST(Staircase, AQuarterOfTheEdgesAreShortSteps) {
  EXPECT_TRUE(is_staircase(stairs(0.1), 0.15));
  EXPECT_FALSE(is_staircase(stairs(0.1), 0.05));
  EXPECT_FALSE(is_staircase({{{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}}}}, 20));
}

}  // namespace
}  // namespace oxturn
