// Where a robot that sweeps along horizontal lines touches something: the subgoals of Hyun's planner.
//
// Every maximal free interval of configuration space on a line gives two points, its left and its right contact, each with
// what is touched there. O(n + k log k) for n edges of the space that cross lines k times.
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
  int obstacle;  // 0: the wall; else which hole of the space, from 1
};

struct TrackingLines {
  std::vector<TrackingPoint>
      points;                      // by lines, each from left to right: left and right contact of each interval in turn
  std::vector<std::size_t> first;  // of each line, and one past the last
};

/// Lines `separation` apart from the top of the space, and a last one at its bottom. `spare`: how far lines keep off the
/// top and the bottom, and contacts off the border, so that they are inside in spite of rounding; an interval shorter than
/// twice that becomes its middle. `delta_x` > 0: contacts are moved inwards to multiples of it from the left end of the
/// space, and intervals without any are left out.
TrackingLines tracking_lines(const Region& space, double separation, double spare, double delta_x);

}  // namespace oxturn
