#include "metrics/disc_area.hpp"

namespace oxturn {

Ring clipped_left(const Ring& ring, const Point& a, const Point& b) {
  Ring kept;
  const auto side = [&](const Point& p) { return cross(b - a, p - a); };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const double at_p = side(p), at_q = side(q);
    if (at_p >= 0) kept.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return kept;
}

}  // namespace oxturn
