// Source      Blackman, Vigna: Scrambled Linear Pseudorandom Number Generators, 2018 (xoshiro256** 1.0);
//             Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators, 2014 (splitmix64).
#include "base/random.hpp"

#include <bit>
#include <cmath>
#include <numbers>

namespace oxturn {
namespace {

std::uint64_t splitmix64(std::uint64_t& state) {
  std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// Natural logarithm of x in (0, 1). Uses only operations that IEEE 754 rounds the same way everywhere; the last bit of
/// std::log depends on the C library.
double portable_log(double x) {
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // [0.5, 1)
  if (m < std::numbers::sqrt2 / 2) {
    m *= 2;
    --exponent;
  }
  // log m = 2 artanh s, by its series; |s| < 0.172, so the terms up to s^23 reach 1e-17.
  const double s = (m - 1) / (m + 1), s2 = s * s;
  double sum = 0;
  for (int k = 23; k >= 1; k -= 2) sum = sum * s2 + 1.0 / k;
  return 2 * s * sum + exponent * std::numbers::ln2;
}

}  // namespace

Rng::Rng(std::uint64_t seed) {
  for (auto& word : state_) word = splitmix64(seed);
}

std::uint64_t Rng::bits() {
  const std::uint64_t result = std::rotl(state_[1] * 5, 7) * 9;
  const std::uint64_t t = state_[1] << 17;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= t;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double Rng::unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

std::uint64_t Rng::below(std::uint64_t n) {
  const std::uint64_t excess = (0 - n) % n;  // 2^64 mod n: rejecting so many values leaves a multiple of n
  std::uint64_t x = bits();
  while (x < excess) x = bits();
  return x % n;
}

double Rng::normal() {
  for (;;) {
    const double u = 2 * unit() - 1, v = 2 * unit() - 1, s = u * u + v * v;
    if (s > 0 && s < 1) return u * std::sqrt(-2 * portable_log(s) / s);
  }
}

std::uint64_t mix(std::uint64_t seed, std::string_view words) {
  std::uint64_t h = 0xcbf29ce484222325u;
  for (const char c : words) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  h ^= splitmix64(seed);
  return splitmix64(h);
}

}  // namespace oxturn
