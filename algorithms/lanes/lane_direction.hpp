/// The direction in which to drive parallel lanes.
///
///   const double degrees = best_lane_direction(region, tool_width);
///   const LaneFrame frame(degrees);
#pragma once

#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

/// How a planner chooses the direction of its lanes: by least estimated cost, or as the parameter `angle` says.
enum class LaneDirection { best, given };

/// Of a vector, degrees in [0, 180).
double direction_of(const Point& d);
/// The direction across which a convex polygon with at least 3 vertices is narrowest, degrees in [0, 180): lanes along
/// it are fewest. O(n).
double narrowest_direction(const Ring& hull);

/// Candidate lane directions, degrees in [0, 180): the directions with the most boundary length, those across them,
/// the two axes, and the direction across which the region's convex hull is narrowest. At most 16. O(n log n).
std::vector<double> lane_directions(const Region& region);

/// The candidate with the least estimated cost for lanes `width` metres apart: length of all lanes, plus 2 widths for
/// each lane (its turn), plus 4 widths for each run of consecutive lanes (leaving one run and entering the next).
/// O(candidates * (n + k) log n) for n vertices and k crossings of edges with lanes.
double best_lane_direction(const Region& region, double width);

}  // namespace oxturn
