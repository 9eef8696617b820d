#include "algorithms/lanes/strips.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/seeds.hpp"

namespace oxturn {
namespace {

/// Total length of straight links between lanes that are driven in the given directions.
double links_of(const Strip& strip, const std::vector<bool>& up) {
  double sum = 0;
  for (std::size_t i = 1; i < strip.lanes.size(); ++i) {
    const LaneEnds &from = strip.lanes[i - 1], &to = strip.lanes[i];
    sum += distance(up[i - 1] ? from.high : from.low, up[i] ? to.low : to.high);
  }
  return sum;
}

double least_links_of(const Strip& strip, bool first_up) {
  const std::size_t n = strip.lanes.size();
  double least = 1e9;
  for (std::size_t bits = 0; bits < (std::size_t{1} << (n - 1)); ++bits) {
    std::vector<bool> up{first_up};
    for (std::size_t i = 1; i < n; ++i) up.push_back((bits >> (i - 1) & 1) != 0);
    least = std::min(least, links_of(strip, up));
  }
  return least;
}

TEST(Strip, DirectionsMakeTheLinksShortest) {
  Rng rng(1);
  for (int round = 0; round < 500; ++round) {
    Strip strip;
    for (int i = rng.between(1, 9); i > 0; --i) {
      const double x = static_cast<double>(strip.lanes.size()), low = rng.between(0.0, 4.0);
      strip.lanes.push_back({{x, low}, {x, low + rng.between(0.0, 4.0)}});
    }
    for (const bool first_up : {true, false}) {
      const std::vector<bool> up = strip.directions(first_up);
      EXPECT_EQ(up.front(), first_up);
      EXPECT_NEAR(links_of(strip, up), least_links_of(strip, first_up), 1e-12);
    }
  }
}

// Where a wall recedes: from the top of the first lane, the bottom of the second is nearer than its top, but the link
// back down would be one too many.
TEST(Strip, ALaneIsNotBegunAtItsNearerEndIfThatCostsMoreLater) {
  const Strip strip{.lanes = {{{0, 0}, {0, 2}}, {{1, 0}, {1, 4.2}}, {{2, 0}, {2, 5.2}}}};
  EXPECT_EQ(strip.directions(true), (std::vector<bool>{true, false, true}));
}

TEST(Strip, EqualLinksAlternate) {
  const Strip points{.lanes = {{{0, 0}, {0, 0}}, {{1, 0}, {1, 0}}, {{2, 0}, {2, 0}}}};
  EXPECT_EQ(points.directions(true), (std::vector<bool>{true, false, true}));
}

}  // namespace
}  // namespace oxturn
