// The taut tether along a path: its length, its bends, how it pulls, and where the robot drives over it.
//
// Method      The string (geometry/taut_string.hpp) tells every stretch of the way during which it turns about one place,
//             the pivot. There, with h the pivot's distance from the driven line and s the place on it (0 at the pivot's
//             foot), the angle between heading and string is atan2(h, s): 0 = straight away from the pull, pi = back
//             along the string. Mean and shares are integrals of that in closed form; the length is convex in s, so it
//             is greatest at an end. Nothing is sampled, and how finely a path is cut into segments does not matter.
// Decisions   1. Where the robot stands at the pivot the angle is 0.
//             2. "Sharper" is strictly more than the limit; a limit of pi is never exceeded.
//             3. Entangled: at the end the string is longer than the geodesic of that place by more than 1e-6 of it
//                plus the problem's tolerance.
//             4. A path that jumps, starts elsewhere or leaves free space pulls no string: nothing is told of it.
// Complexity  n segments: O(n) beside the string's own cost and what own_line.hpp says; 10^5 segments well under a second
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/edge_index.hpp"
#include "geometry/path.hpp"
#include "geometry/tether/taut_tether.hpp"
#include "maps/problem.hpp"

namespace oxturn {

/// A stretch of the way with one pivot.
struct TetherStretch {
  TautTether::Swing swing;
  Point heading{1, 0};        // unit vector
  double path_m = 0;          // driven up to its begin
  double begin = 0, end = 0;  // metres along the heading from the pivot's foot, begin <= end
  double height = 0;          // the pivot's distance from the line
  double length_at(double s) const { return swing.before + std::hypot(height, s); }
  double angle_at(double s) const { return std::atan2(height, s); }
};

struct TetherCrossing {
  double path_m = 0;
  Point at{0, 0};
};

/// Told in driving order, each segment's crossings before its stretches. Any may be left out.
struct TetherVisitor {
  std::function<void(const TetherCrossing&)> crossing;
  std::function<void(const TetherStretch&)> stretch;
  std::function<void(const TautTether&, double path_m)> waypoint;  // at the end of each segment
};
/// Drives the string along `way`, which begins at the problem's start (maps/followed_path.hpp).
void drive_tether(const Problem& problem, const Polyline& way, const TetherVisitor& visitor);

struct TetherRun {
  double longest_m = 0;    // the string's greatest length
  Point longest_at{0, 0};  // where the robot is then
  std::size_t bends_max = 0;
  double path_m = 0;     // driven
  double angle_min = 0;  // with no way driven, this and the next two mean nothing
  double angle_sum = 0;  // integral of the angle over the way, rad m
  double sharp_m = 0;    // metres driven with an angle above the tether's sharp_angle
  std::vector<TetherCrossing> crossings;
  double end_m = 0;       // the string's length at the end
  double geodesic_m = 0;  // the shortest that it could be there; infinity where the robot cannot be
};
/// Tethered problems only. Nothing for paths of Decision 4. `walls`: edges of the map's free space.
std::optional<TetherRun> tether_run(const Problem& problem, const Path& path, const EdgeIndex& walls);

/// "pulls its tether to 12.3 m at (3, 4), 0.3 m over its limit 12 m", or "" if the limit is kept (within the problem's
/// tolerance and 1e-9 of it).
std::string find_tether_flaw(const Problem& problem, const std::optional<TetherRun>& run);

}  // namespace oxturn
