// Thinned lines against distances that are measured point by point.
#include "geometry/thinned.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/random.hpp"

namespace oxturn {
namespace {

double distance_to(const Polyline& line, const Point& p) {
  double least = distance(p, line.front());
  for (std::size_t k = 1; k < line.size(); ++k) least = std::min(least, distance_to_segment(p, line[k - 1], line[k]));
  return least;
}

Polyline wandering(int n, double step, std::uint64_t seed) {
  Rng rng(seed);
  Polyline line{{0, 0}};
  double angle = 0;
  for (int k = 1; k < n; ++k) {
    angle += rng.unit() < 0.02 ? 6 * rng.unit() - 3 : rng.unit() - 0.5;
    line.push_back(line.back() + step * rng.unit() * Point(std::cos(angle), std::sin(angle)));
  }
  return line;
}

TEST(Thinned, StaysWithinTheErrorBothWays) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Polyline line = wandering(400, 0.01, seed);
    for (const double error : {0.002, 0.02}) {
      const Polyline thin = thinned(line, error);
      EXPECT_LT(thin.size(), line.size());
      EXPECT_EQ(thin.front(), line.front());
      EXPECT_EQ(thin.back(), line.back());
      for (const Point& p : line) EXPECT_LE(distance_to(thin, p), error * (1 + 1e-9));
      for (std::size_t k = 1; k < thin.size(); ++k)
        for (const double share : {0.0, 0.25, 0.5, 0.75})
          EXPECT_LE(distance_to(line, lerp(thin[k - 1], thin[k], share)), error * (1 + 1e-9));
    }
  }
}

TEST(Thinned, StraightLinesBecomeOneSegmentAndTurnsStay) {
  Polyline line;
  for (int k = 0; k <= 100; ++k) line.push_back({0.07 * k, 0.03 * k});
  EXPECT_EQ(thinned(line, 1e-6), (Polyline{line.front(), line.back()}));
  const Polyline there_and_back{{0, 0}, {1, 0}, {0, 0}};
  EXPECT_EQ(thinned(there_and_back, 0.1), there_and_back);
  EXPECT_EQ(thinned({{1, 2}, {1, 2}}, 0.1), (Polyline{{1, 2}, {1, 2}}));
}

TEST(Thinned, DenseAreLinesWithVerticesNearEachOther) {
  EXPECT_TRUE(is_dense({{0, 0}, {1, 0}, {2, 0}}, 1));
  EXPECT_FALSE(is_dense({{0, 0}, {1, 0}, {2, 0}}, 0.5));
  EXPECT_FALSE(is_dense({{0, 0}, {0, 0}}, 1));
}

}  // namespace
}  // namespace oxturn
