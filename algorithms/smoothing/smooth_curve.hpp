/// Curves driven forwards whose curvature need not jump: clothoids (lines and arcs among them) and Bézier curves.
///
///   const SmoothCurve curve = smooth_connection(from, to, {.radius = 0.5}).curve;   // connection.hpp
///   if (largest_curvature(curve) <= 1 / radius) path.drive(sampled(curve, 0.003), false);
///
/// Where a Polyline is wanted, sampled() gives one that leaves the curve by a bounded error.
///
/// Complexity  O(1) for a point of a piece; sampled() O(points)
#pragma once

#include <variant>
#include <vector>

#include "algorithms/smoothing/bezier.hpp"
#include "algorithms/smoothing/clothoid.hpp"
#include "algorithms/smoothing/curve.hpp"

namespace oxturn {

struct SmoothCurve {
  Pose from, to;
  std::vector<std::variant<Clothoid, Bezier>> pieces = {};  // each begins where the one before ends
};

/// Lines and arcs as clothoids. Throws std::invalid_argument if a piece is driven in reverse.
SmoothCurve smooth_curve(const Curve& curve);

/// Metres; Bézier curves by quadrature, to 1e-6 of the length.
double length(const SmoothCurve& curve);
/// The greatest absolute curvature, 1/m; of Bézier curves that of 64 samples a piece, refined. Infinite at a cusp.
double largest_curvature(const SmoothCurve& curve);
/// All coordinates are finite.
bool finite(const SmoothCurve& curve);
/// The largest gap between a piece's end and the next one's begin, and between the curve's ends and `from` and `to`.
/// Metres for positions, radians for headings.
struct JointErrors {
  double position = 0, heading = 0;
};
JointErrors joint_errors(const SmoothCurve& curve);

/// Chords that leave the curve by `chord_error` metres at most, from `from.at` to `to.at` exactly. At least two points
/// unless the curve has no length; consecutive ones differ.
Polyline sampled(const SmoothCurve& curve, double chord_error);

/// The polyline in equal steps of arc length, `step` metres at most, as a controller reads a path; its ends are kept,
/// vertices between them are not.
Polyline evenly_sampled(const Polyline& line, double step);

}  // namespace oxturn
