#include "base/random.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <numeric>
#include <vector>

namespace oxturn {
namespace {

// Oracles written from the papers, themselves checked against published values.
struct Splitmix {
  std::uint64_t x;
  std::uint64_t next() {
    x += 0x9e3779b97f4a7c15u;
    std::uint64_t z = x;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
};
struct Xoshiro {
  std::uint64_t s[4];
  std::uint64_t next() {
    const std::uint64_t result = std::rotl(s[1] * 5, 7) * 9, t = s[1] << 17;
    s[2] ^= s[0], s[3] ^= s[1], s[1] ^= s[2], s[0] ^= s[3], s[2] ^= t;
    s[3] = std::rotl(s[3], 45);
    return result;
  }
};

TEST(Rng, IsXoshiroSeededBySplitmix) {
  Splitmix zero{0};
  for (const std::uint64_t v : {0xe220a8397b1dcdafu, 0x6e789e6aa1b965f4u, 0x06c45d188009454fu, 0xf88bb8a8724c81ecu})
    EXPECT_EQ(zero.next(), v);
  Xoshiro x{{1, 2, 3, 4}};
  for (const std::uint64_t v :
       {std::uint64_t{11520}, std::uint64_t{0}, std::uint64_t{1509978240}, std::uint64_t{1215971899390074240}})
    EXPECT_EQ(x.next(), v);
  for (const std::uint64_t seed : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{0xdeadbeef12345678}}) {
    Splitmix mixer{seed};
    Xoshiro truth{};
    for (auto& w : truth.s) w = mixer.next();
    Rng rng(seed);
    for (int k = 0; k < 1000; ++k) ASSERT_EQ(rng.bits(), truth.next());
  }
}

TEST(Rng, BelowIsUniform) {
  Rng rng(7);
  std::vector<int> seen(10);
  for (int k = 0; k < 100000; ++k) ++seen[rng.below(10)];
  for (const int n : seen) EXPECT_NEAR(n, 10000, 500);  // 5 sigma
  for (int k = 0; k < 100; ++k) EXPECT_EQ(rng.below(1), 0u);
  // n is two thirds of 2^64: without rejection the lower half would be twice as likely as the upper.
  const std::uint64_t n = 0xaaaaaaaaaaaaaaaau;
  int low = 0;
  for (int k = 0; k < 10000; ++k) low += rng.below(n) < n / 2 ? 1 : 0;
  EXPECT_NEAR(low, 5000, 250);
}

TEST(Rng, DrawsStayInTheirRanges) {
  Rng rng(3);
  double sum = 0;
  bool ends[2] = {false, false};
  for (int k = 0; k < 10000; ++k) {
    const double u = rng.unit();
    ASSERT_TRUE(u >= 0 && u < 1);
    sum += u;
    const int d = rng.between(-2, 2);
    ASSERT_TRUE(d >= -2 && d <= 2);
    ends[0] = ends[0] || d == -2;
    ends[1] = ends[1] || d == 2;
  }
  EXPECT_NEAR(sum / 10000, 0.5, 0.015);
  EXPECT_TRUE(ends[0] && ends[1]);
}

TEST(Rng, NormalHasTheRightMoments) {
  Rng rng(9);
  constexpr int n = 100000;
  double one = 0, two = 0, four = 0;
  int within = 0;
  for (int k = 0; k < n; ++k) {
    const double x = rng.normal();
    one += x, two += x * x, four += x * x * x * x;
    within += std::abs(x) < 1 ? 1 : 0;
  }
  EXPECT_NEAR(one / n, 0, 0.016);
  EXPECT_NEAR(two / n, 1, 0.025);
  EXPECT_NEAR(four / n, 3, 0.2);
  EXPECT_NEAR(within / double{n}, 0.6827, 0.008);
}

// Marsaglia's polar method with the C library's logarithm.
TEST(Rng, NormalIsAccurateToTheLastDigits) {
  Rng rng(5), units(5);
  for (int k = 0; k < 10000; ++k) {
    double u = 0, s = 0;
    do {
      u = 2 * units.unit() - 1;
      const double v = 2 * units.unit() - 1;
      s = u * u + v * v;
    } while (s == 0 || s >= 1);
    const double expected = u * std::sqrt(-2 * std::log(s) / s);
    EXPECT_NEAR(rng.normal(), expected, 1e-14 * std::abs(expected) + 1e-16);
  }
}

TEST(Rng, ShuffleIsAUniformPermutation) {
  Rng rng(4);
  std::vector<int> orders(6);
  for (int k = 0; k < 60000; ++k) {
    std::vector<int> v{0, 1, 2};
    rng.shuffle(v);
    ++orders[static_cast<std::size_t>(v[0] * 2 + (v[1] > v[2] ? 1 : 0))];
  }
  EXPECT_EQ(std::accumulate(orders.begin(), orders.end(), 0), 60000);
  for (const int n : orders) EXPECT_NEAR(n, 10000, 500);
}

TEST(Mix, DependsOnSeedAndEveryCharacter) {
  EXPECT_EQ(mix(1, "planner"), mix(1, "planner"));
  EXPECT_NE(mix(1, "planner"), mix(2, "planner"));
  EXPECT_NE(mix(1, "planner"), mix(1, "plannes"));
  EXPECT_NE(mix(1, "ab"), mix(1, "ba"));
  EXPECT_NE(mix(1, ""), mix(2, ""));
}

}  // namespace
}  // namespace oxturn
