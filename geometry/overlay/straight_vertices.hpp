/// Removes the vertices of a ring at which it does not turn. Private to geometry, not installed.
///
///   ring = without_straight_vertices(ring, [](auto& a, auto& b, auto& c) { return orientation(a, b, c) == 0; });
#pragma once

#include <cstddef>
#include <vector>

namespace oxturn {

/// Removes vertices for which straight(previous, vertex, next) is true until none is left: repeated points, collinear
/// vertices and spikes that run back on themselves, also where one removal causes another. Empty if fewer than three
/// vertices are left. O(n).
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
