/// The only source of randomness in oxturn.
///
///   Rng rng(mix(suite_seed, "rooms"));
///   const double width = rng.between(0.8, 1.2);
///   rng.shuffle(order);
///
/// A fixed 64-bit generator (xoshiro256**, Blackman and Vigna 2018, seeded by splitmix64) with distributions of our
/// own: those of the standard library differ between implementations. The same seed gives the same bytes on every
/// machine.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

namespace oxturn {

class Rng {
 public:
  explicit Rng(std::uint64_t seed);
  /// 64 random bits.
  std::uint64_t bits();
  /// Uniform in [0, 1), 53 bits.
  double unit();
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// Uniform in 0 .. n-1, without bias; n > 0.
  std::uint64_t below(std::uint64_t n);
  /// Uniform in low .. high, both included.
  int between(int low, int high) { return low + static_cast<int>(below(static_cast<std::uint64_t>(high - low) + 1)); }
  bool chance(double probability) { return unit() < probability; }
  /// Standard normal, by Marsaglia's polar method.
  double normal();
  template <class Container>
  void shuffle(Container& c) {
    for (std::size_t i = c.size(); i > 1; --i) std::swap(c[i - 1], c[below(i)]);
  }

 private:
  std::array<std::uint64_t, 4> state_{};
};

/// A seed derived from a seed and a text (FNV-1a, then splitmix64): independent streams for mix(seed, "planner") and
/// mix(seed, "map").
std::uint64_t mix(std::uint64_t seed, std::string_view words);

}  // namespace oxturn
