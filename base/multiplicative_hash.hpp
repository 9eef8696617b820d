/// Multiplicative hashing.
///
///   slots[(key * kHashFactor >> 32) & (slots.size() - 1)]
///
/// Source      Knuth, The Art of Computer Programming, volume 3, section 6.4
#pragma once

#include <cstdint>

namespace oxturn {

/// 2^64 over the golden ratio. The upper half of the product with a key is well mixed.
inline constexpr std::uint64_t kHashFactor = 0x9e3779b97f4a7c15;

}  // namespace oxturn
