// The only randomness in oxturn: a fixed 64-bit generator (xoshiro256**, Blackman & Vigna 2018, seeded by
// splitmix64) and the few draws we need, written out so that every machine gives the same bytes.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <utility>

namespace oxturn {

class Rng {
 public:
  explicit Rng(std::uint64_t seed);
  std::uint64_t bits();
  /// [0, 1), 53 bits.
  double unit();
  double between(double low, double high) { return low + (high - low) * unit(); }
  /// 0 .. n-1 without bias; n > 0.
  std::uint64_t below(std::uint64_t n);
  int between(int low, int high) {  // both included
    return low + static_cast<int>(below(static_cast<std::uint64_t>(high - low) + 1));
  }
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

/// A seed from words, the same everywhere (FNV-1a, then splitmix64): mix(suite_seed, "planner").
std::uint64_t mix(std::uint64_t seed, std::string_view words);

}  // namespace oxturn
