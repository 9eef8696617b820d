/// A smooth connection between two poses that keeps a least turning radius: there is always one.
///
///   const Connection c = smooth_connection(end_of_stroke, begin_of_next, {.radius = 0.5});
///   path.drive(sampled(c.curve, 0.003), false);
///   viewer.handles(c.through);                                  // what a person may drag
///   const auto edited = edited_connection(from, to, ConnectionKind::spiro, points, 0.5);
///
/// Tried in turn, until one keeps the curvature (1 % more is allowed, as for curves that are sampled), has continuous
/// tangents, is not longer than d + 8 pi radius (d: the distance) and is `allowed`:
///   1. spiro curves with rho = 2, 2.25, 2.5, 3, 3.5, 4 and 5 radii
///   2. a quintic Bézier curve
///   3. Dubins-like curves of continuous curvature, shortest first
///   4. Dubins curves, shortest first: these exist for all poses
/// Complexity  130 microseconds on average
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "algorithms/smoothing/smooth_curve.hpp"
#include "algorithms/smoothing/spiro.hpp"

namespace oxturn {

enum class ConnectionKind { spiro, bezier, clothoid, dubins };

struct ConnectionOptions {
  double radius = 1;                             // least turning radius, metres, > 0
  double sharpness = 0;                          // of clothoids, 1/m^2; 0: 2 / radius^2
  ConnectionKind first = ConnectionKind::spiro;  // where the list above begins
  bool shortest = false;                         // of all that 1 to 3 find, not the first one; three times the time
  /// `literal`: the first spiro curve (rho = 2 radii) without tests, if it is finite, as Vollprecht drives it.
  SpiroRule rule = SpiroRule::improved;
  /// Whether a curve may be driven (canvas, finished work); empty: anywhere. If no curve is allowed, the result is the
  /// first one that keeps the radius, with `allowed` false.
  std::function<bool(const SmoothCurve&)> allowed = {};
};

struct Connection {
  SmoothCurve curve;
  ConnectionKind kind = ConnectionKind::dubins;
  std::vector<Point> through = {};  // control points of a spiro curve, inner ones of a Bézier curve: what can be edited
  double curvature = 0;             // the greatest, 1/m
  bool allowed = true;
};

/// `from` and `to` may be any finite poses, also the same. Throws std::invalid_argument for others.
Connection smooth_connection(const Pose& from, const Pose& to, const ConnectionOptions& options);

/// With the control points of a person: a spiro curve through `points`, or the Bézier curve of which they are the inner
/// control points. It is obeyed whatever its curvature (see Connection::curvature); for `bezier` the headings at the
/// ends are what the points say. nullopt: not finite, or libspiro finds none. Other kinds, and Bézier curves of more
/// than 32 points, throw std::invalid_argument.
std::optional<Connection> edited_connection(const Pose& from, const Pose& to, ConnectionKind kind,
                                            const std::vector<Point>& points, double radius);

}  // namespace oxturn
