#include "geometry/overlay/swath.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "base/random.hpp"

namespace oxturn {
namespace {

TEST(Swath, OfASegmentIsACapsule) {
  const double error = 1e-4, exact = 2 * 0.5 * 3 + kPi * 0.25;
  for (const double angle : {0.0, 0.3, 2.0, kPi}) {
    const Polyline line{{1, 1}, Point(1, 1) + rotated({3, 0}, angle)};
    const double inside = area(swath({line}, 0.5, error, Bound::inside));
    const double outside = area(swath({line}, 0.5, error, Bound::outside));
    EXPECT_LT(inside, exact);
    EXPECT_GT(outside, exact);
    EXPECT_GT(inside, exact - kPi * error);
    EXPECT_LT(outside, exact + kPi * error);
  }
}

TEST(Swath, OfAPointIsADiscAndOfNothingIsNothing) {
  EXPECT_NEAR(area(swath({{{2, 3}}}, 1, 1e-5, Bound::inside)), kPi, 1e-4);
  EXPECT_NEAR(area(swath({{{2, 3}, {2, 3}}}, 1, 1e-5, Bound::outside)), kPi, 1e-4);
  EXPECT_TRUE(swath({}, 1, 0.1, Bound::inside).empty());
  EXPECT_THROW(swath({{{0, 0}}}, 0, 0.1, Bound::inside), std::invalid_argument);
  EXPECT_THROW(swath({{{0, 0}}}, 1, 0, Bound::inside), std::invalid_argument);
}

// Points are in the swath if they are near a segment, but for the chord error.
TEST(Swath, AgreesWithDistances) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Rng rng(seed);
    const auto any = [&] { return Point(rng.between(0.0, 4.0), rng.between(0.0, 4.0)); };
    std::vector<Polyline> lines(rng.below(3) + 1);
    for (Polyline& line : lines)
      for (std::uint64_t n = rng.below(8) + 1; n > 0; --n) line.push_back(any());
    const double radius = rng.between(0.05, 0.6), error = radius / 50;
    const Region inside = swath(lines, radius, error, Bound::inside);
    const Region outside = swath(lines, radius, error, Bound::outside);
    for (int k = 0; k < 300; ++k) {
      const Point p = any();
      double least = 1e9;
      for (const Polyline& line : lines)
        for (std::size_t i = 0; i < line.size(); ++i)
          least = std::min(least, distance_to_segment(p, line[i], line[std::min(i + 1, line.size() - 1)]));
      if (least < radius - error) { EXPECT_TRUE(contains(inside, p)) << seed; }
      if (least > radius) { EXPECT_FALSE(contains(inside, p)) << seed; }
      if (least < radius) { EXPECT_TRUE(contains(outside, p)) << seed; }
      if (least > radius + error) { EXPECT_FALSE(contains(outside, p)) << seed; }
    }
  }
}

}  // namespace
}  // namespace oxturn
