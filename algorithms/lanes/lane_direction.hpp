// Which way to drive the lanes.
#pragma once

#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

/// Lane directions worth trying, degrees in [0, 180): the directions that most boundary length has, those across
/// them, the two axes, and the one in which the region's convex hull is narrowest to sweep. At most 16. O(n log n).
std::vector<double> lane_directions(const Region& region);

/// The candidate with the least estimated cost of sweeping `region` with lanes `width` apart: length of all lanes,
/// plus 2 widths for each lane (its turn), plus 4 for each run of lanes that must be left and entered anew.
/// O(candidates * (n + crossings) log n).
double best_lane_direction(const Region& region, double width);

}  // namespace oxturn
