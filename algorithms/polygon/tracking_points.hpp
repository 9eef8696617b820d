/// The contacts of a robot that moves along horizontal lines: the subgoals of Hyun's planner.
///
///   const TrackingLines lines = tracking_lines(problem.configuration_space(), 0.2, 1e-6, 0);
///   lines.points[0].at;                                  // left contact of the first interval of the top line
///
/// Every maximal free interval of configuration space on a line gives two points, its left and its right contact, each
/// with what the robot touches there. O(n + k log k) for n edges of the space that cross lines k times.
#pragma once

#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

enum class Contact { left_wall, right_wall, left_obstacle, right_obstacle };
inline bool is_left(Contact c) { return c == Contact::left_wall || c == Contact::left_obstacle; }

struct TrackingPoint {
  Point at;
  int line;  // 0: the topmost
  Contact status;
  int obstacle;  // 0: the wall; else the number of the hole, from 1
};

struct TrackingLines {
  /// By line, each from left to right: the left and the right contact of each interval in turn.
  std::vector<TrackingPoint> points;
  std::vector<std::size_t> first;  // index of each line's first point; a last entry: points.size()
};

/// Lines `separation` apart from the top of the space, and one at its bottom. `keep_off`: metres that lines keep from
/// the top and the bottom, and contacts from the boundary, so that they are inside in spite of rounding; an interval
/// shorter than twice that becomes its midpoint. `delta_x` > 0: contacts are moved inwards to multiples of it, counted
/// from the left end of the space; intervals without such a point are omitted.
TrackingLines tracking_lines(const Region& space, double separation, double keep_off, double delta_x);
/// The same if only `needed`, a part of the space, has to be covered: lines lie in the middle of slabs over it that are
/// at most `separation` wide, and intervals next to which nothing of it lies in their slab are omitted.
TrackingLines tracking_lines(const Region& space, const Region& needed, double separation, double keep_off,
                             double delta_x);

}  // namespace oxturn
