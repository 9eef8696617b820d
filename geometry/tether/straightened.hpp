/// How much of a path a taut tether need not follow point by point.
///
///   if (const std::size_t n = points_to_skip(corners, tether.robot(), points, first); n > 0)
///     tether.drive(points[first + n]);   // comes to lie as if it had been driven to each of the points
///
/// Method      The points lie in a triangle with one vertex at the robot. Where no corner is in it, free space in it is
///             convex, as far as the robot can get there without leaving it: so the straight segment to the last point
///             is free, and in the homotopy class of the path.
#pragma once

#include <cstddef>

#include "geometry/point.hpp"

namespace oxturn {

class TautSpace;

/// So many of points[first ..], kMostSkipped at most, may be left out by a robot at `from`: it can drive straight to
/// the one that follows them. O(points + corners near by).
std::size_t points_to_skip(const TautSpace& corners, const Point& from, const Polyline& points, std::size_t first);

constexpr std::size_t kMostSkipped = 15;

}  // namespace oxturn
