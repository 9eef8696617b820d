/// Which edges a horizontal ray crosses: the even-odd rule of point location.
///
///   bool odd = false;
///   for_each_edge(region, [&](const Point& a, const Point& b) { odd ^= crosses_ray(a, b, p); });
#pragma once

#include "geometry/predicates.hpp"

namespace oxturn {

/// Does the edge ab cross the ray from p in the direction of +x? Exact; the lower end of an edge belongs to it, the
/// upper one does not.
inline bool crosses_ray(const Point& a, const Point& b, const Point& p) {
  const bool up = a.y() <= p.y();
  if (up == (b.y() <= p.y())) return false;
  if (a.x() <= p.x() && b.x() <= p.x()) return false;
  return (orientation(a, b, p) > 0) == up;
}

}  // namespace oxturn
