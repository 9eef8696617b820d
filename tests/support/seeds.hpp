// 1 .. n, for loops over random cases; SCOPED_TRACE the seed and a failure can be replayed.
#pragma once

#include <cstdint>
#include <vector>

namespace oxturn {

inline std::vector<std::uint64_t> seeds(std::uint64_t n) {
  std::vector<std::uint64_t> all;
  for (std::uint64_t s = 1; s <= n; ++s) all.push_back(s);
  return all;
}

}  // namespace oxturn
