/// Where a path changes its heading, and which changes belong to one bend. In reverse the heading is opposite to the
/// motion, so a change of gear on a straight line is no turn. For turns, turn_rad and mission_s; private
/// to metrics/.
///
///   for (const Turn& turn : headings(problem, path).turns) total += std::abs(turn.angle);
///
/// Planners sample curves as chords with a chord error of up to w / 1000 (w = tool width), so a single vertex says
/// little. Two consecutive changes of the same sense are linked into one bend unless
///   1. the segment between them is w / 2 or longer: a chord of that length belongs to a curve of radius above 31 w, or
///      to no curve; or they are that far apart with only gentler curving (radius above 31 w) in between; or
///   2. one of them is above 0.3 rad and the segment between them is no chord of such a curve (its chord error would be
///      above 1.5 w / 1000): a polygon's corner.
/// Both tests depend on the curve, not on its samples, so finer sampling changes no answer. Curving at a radius above
/// 31 w is driving, not turning: it adds to turn_rad only.
#pragma once

#include <vector>

#include "metrics/score.hpp"

namespace oxturn {

inline constexpr double kCorner = 0.3;  // radians at one vertex

/// One change of heading along the path (transit included).
struct Turn {
  double angle = 0;     // signed, radians, never 0
  double before = 0;    // metres of straight line before it
  bool linked = false;  // part of the same bend as the turn before
};

struct Headings {
  std::vector<Turn> turns;
  double after = 0;  // metres of straight line after the last turn
};

/// Points nearer together than the problem's tolerance count as one. O(n).
Headings headings(const Problem& problem, const Path& path);

}  // namespace oxturn
