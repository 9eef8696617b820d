/// The convex hull of points in the plane.
///
///   const Ring hull = convex_hull(points);      // counter-clockwise, from the lowest point in lexicographic order
///
/// O(n log n), with exact predicates.
/// Source: Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979 (monotone chain).
#pragma once

#include "geometry/region.hpp"

namespace oxturn {

/// Vertices of the hull only: no repeated points, none inside an edge. Points on one line give its two ends; a single
/// point gives itself. The points must be finite.
Ring convex_hull(std::vector<Point> points);

}  // namespace oxturn
