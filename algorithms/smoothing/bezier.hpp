/// Bézier curves of any degree, and connections of two poses by cubic and quintic ones.
///
///   const Bezier cubic = cubic_connection(from, to, distance(from.at, to.at) / 3);
///   const Bezier quintic = quintic_connection(from, to, 0.5);    // no curvature at the ends
///
/// Source      the quintic has P1 = P0 + h u, P2 = P0 + 2 h u and the same mirrored at the end (u is the
///             heading), so it begins and ends without curvature, as straight lines do
/// Complexity  O(degree) a point; quintic_connection some thousand points: 50 microseconds
#pragma once

#include <vector>

#include "algorithms/smoothing/curve.hpp"

namespace oxturn {

struct Bezier {
  std::vector<Point> points = {};  // degree + 1 control points, at least two
};

Point position_at(const Bezier& curve, double t);
/// Derivative by t.
Point velocity_at(const Bezier& curve, double t);
/// Signed curvature, positive to the left. Infinite where the velocity is zero.
double curvature_at(const Bezier& curve, double t);
/// The greatest absolute curvature: of 64 samples, refined by golden sections around the greatest ones; where the
/// heading changes much between two samples, as it does near a cusp, also the mean curvature between them.
double largest_curvature(const Bezier& curve);
double length(const Bezier& curve);

/// Handles of `handle` metres at both ends; kept for comparison.
Bezier cubic_connection(const Pose& from, const Pose& to, double handle);
/// With the h in [d / 8, d + 4 radius] of the least greatest curvature, d being the distance.
Bezier quintic_connection(const Pose& from, const Pose& to, double radius);

}  // namespace oxturn
