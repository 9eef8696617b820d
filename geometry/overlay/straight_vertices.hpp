// Rings without corners that turn nowhere. Private to geometry: not installed.
#pragma once

#include <cstddef>
#include <vector>

namespace oxturn {

/// Drops corners for which straight(before, corner, after) holds, until none is left: duplicates, collinear corners
/// and spikes that run back exactly, in chains too. Fewer than three corners: nothing remains. O(n).
template <class P, class Straight>
std::vector<P> without_straight_vertices(const std::vector<P>& ring, Straight straight) {
  std::vector<P> out;
  out.reserve(ring.size());
  for (const P& p : ring) {
    while (out.size() >= 2 && straight(out[out.size() - 2], out.back(), p)) out.pop_back();
    if (out.size() == 1 && out.back() == p) continue;
    out.push_back(p);
  }
  std::size_t head = 0;
  for (bool changed = true; changed && out.size() - head >= 3;) {  // where the ring closes
    changed = false;
    if (straight(out[out.size() - 2], out.back(), out[head])) {
      out.pop_back();
      changed = true;
    } else if (straight(out.back(), out[head], out[head + 1])) {
      ++head;
      changed = true;
    }
  }
  if (out.size() - head < 3) return {};
  out.erase(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(head));
  return out;
}

}  // namespace oxturn
