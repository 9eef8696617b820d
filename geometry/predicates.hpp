// Exact signs. Everything that decides topology asks here, never a rounded cross product.
#pragma once

#include <cmath>

#include "geometry/point.hpp"

namespace oxturn {

/// +1 if a, b, c turn left, -1 right, 0 exactly collinear. Exact for coordinates that are 0 or between 1e-130 and
/// 1e130 in size (beyond, products leave the range of a double); a filter makes the common case a few nanoseconds.
inline int orientation(const Point& a, const Point& b, const Point& c);
/// p on the closed segment ab, exactly.
bool on_segment(const Point& p, const Point& a, const Point& b);
enum class Crossing { none, proper, touch, overlap };
/// How the closed segments ab and cd meet: `proper` = interiors cross in one point; `touch` = one point that is
/// an end of at least one; `overlap` = collinear with a common stretch of positive length.
Crossing crossing(const Point& a, const Point& b, const Point& c, const Point& d);

/// What orientation() asks where its filter cannot tell.
int orientation_unfiltered(const Point& a, const Point& b, const Point& c);

inline int orientation(const Point& a, const Point& b, const Point& c) {
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double det = left - right;
  const double bound = 3.3306690738754716e-16 * (std::abs(left) + std::abs(right));
  if (det > bound && det > 1e-280) return 1;  // below that, products may have underflowed
  if (-det > bound && -det > 1e-280) return -1;
  return orientation_unfiltered(a, b, c);
}

}  // namespace oxturn
