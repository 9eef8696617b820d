/// Corners of a polyline for a robot with a least turning radius: rounded inside, driven round outside, or a stop.
///
///   const RoundedLine line = rounded_corners(stroke, {3, 7}, {.radius = 0.5, .largest_deviation = 0.03});
///   for (const Leg& leg : line.legs) path.drive(leg.points, leg.tool, leg.gear, width);
///
///     inside            outside (tool up): the bulb begins and ends in the vertex with both tangents
///      ____                  .-.
///          '.          -----+---+     Arcs by d/2 - g with the corner, 2 pi - 2 g against it, d/2 - g with it,
///            \              |'-'      where d is the change of heading and g = asin(sin(d/2) / 2). For all corners
///             |             |         at most 7 pi R / 3 long, and at most (1 + sqrt 3) R away from the vertex.
///
/// Inside: an arc, or clothoids, that begins R tan(d/2) (more for clothoids) before the vertex. It fits if the edges
/// beside the vertex are long enough for it and its neighbours.
/// Source      rounding inside and outside by a threshold angle: Vollprecht 2014; his loop (straight, arc, straight)
///             has no bound for sharp corners (`literal`). The bulb is ours.
/// Guarantee   tangents are continuous but at stops; curvature <= 1 / radius
/// Complexity  O(n) for n vertices, and a test of `free` for each loop
#pragma once

#include <functional>
#include <vector>

#include "algorithms/smoothing/smooth_curve.hpp"

namespace oxturn {

/// `automatic`: inside if it fits and leaves the vertex by `largest_deviation` at most, else outside, else a stop.
/// Where `inside` does not fit or `outside` is not free, the robot stops. `literal` is Vollprecht's rule: outside, by
/// his loop, where the inner angle is below 1.57, else inside; corners whose arc does not fit are kept.
enum class CornerRule { automatic, inside, outside, stop, literal };

struct CornerOptions {
  CornerRule rule = CornerRule::automatic;
  double radius = 1;             // least turning radius, metres, > 0
  double sharpness = -1;         // of clothoids, 1/m^2; 0: 2 / radius^2; negative: arcs
  double largest_deviation = 0;  // metres that `automatic` may leave a vertex
  double chord_error = 1e-3;     // metres
  bool reverse = false;          // three-point turns may replace bulbs where they are shorter
  bool may_stop = true;          // the robot can turn on the spot
  /// Whether a loop outside may be driven (canvas, finished work); empty: anywhere.
  std::function<bool(const Polyline&)> free = {};
};

struct RoundedLine {
  std::vector<Leg> legs;            // tool on along the polyline, off in loops outside; one ends at each stop
  std::vector<std::size_t> stops;   // vertices where the robot stops and turns
  std::vector<std::size_t> failed;  // vertices that could not be rounded where it may not stop; kept as they are
};

/// `corners`: increasing indices of inner vertices; the others belong to curves and are kept as they are. Throws
/// std::invalid_argument if an index is not that of an inner vertex.
RoundedLine rounded_corners(const Polyline& line, const std::vector<std::size_t>& corners,
                            const CornerOptions& options);

/// Inner vertices at which the heading changes by more than `angle` radians.
std::vector<std::size_t> corners_of(const Polyline& line, double angle);

/// The shortest loop from the pose `at` back to its position, with the heading changed by `deflection` (left positive,
/// between -pi and pi).
Curve bulb(const Pose& at, double deflection, double radius);
/// Vollprecht's: straight on, round and straight back. As long as it likes for sharp corners.
Curve straight_loop(const Pose& at, double deflection, double radius);

}  // namespace oxturn
