/// Exact geometric predicates. Every decision about topology is made here, never by a rounded cross product.
///
///   orientation(a, b, c) > 0                    // a, b, c turn left
///   crossing(a, b, c, d) == Crossing::proper    // the segments ab and cd cross in their interiors
///
/// Why not CGAL's: hidden behind a header without CGAL types its orientation
/// (Exact_predicates_inexact_constructions_kernel) costs a call and three conversions. Nanoseconds for each
/// orientation, GCC 12, by `oxturn_alternatives --benchmark_filter=Orientation`:
///
///   points                       ours   CGAL inline   CGAL behind this header
///   in general position           1.8           2.3                       6.8
///   collinear up to rounding       63            90                        93
///   exactly collinear              35            13                        17
#pragma once

#include <cmath>

#include "geometry/point.hpp"

namespace oxturn {

/// +1 if a, b, c turn left, -1 if they turn right, 0 if they are exactly collinear. Exact for coordinates that are 0 or
/// between 1e-130 and 1e130 in magnitude: beyond, products leave the range of a double.
inline int orientation(const Point& a, const Point& b, const Point& c);
/// Is p on the closed segment ab? Exact.
bool on_segment(const Point& p, const Point& a, const Point& b);
enum class Crossing {
  none,
  proper,   // the interiors cross in one point
  touch,    // one common point, an end of at least one of the segments
  overlap,  // collinear, with a common segment of positive length
};
/// How the closed segments ab and cd meet. Exact.
Crossing crossing(const Point& a, const Point& b, const Point& c, const Point& d);

/// What orientation() calls where rounded numbers do not decide.
int orientation_unfiltered(const Point& a, const Point& b, const Point& c);

inline int orientation(const Point& a, const Point& b, const Point& c) {
  constexpr double kErrorBound = 3.3306690738754716e-16;  // (3 + 16 u) u with u = 2^-53: Shewchuk 1997
  constexpr double kUnderflow = 1e-280;                   // below, the products may have lost bits to underflow
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double det = left - right;
  const double bound = kErrorBound * (std::abs(left) + std::abs(right));
  if (det > bound && det > kUnderflow) return 1;
  if (-det > bound && -det > kUnderflow) return -1;
  return orientation_unfiltered(a, b, c);
}

}  // namespace oxturn
