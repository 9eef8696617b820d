/// A fill whose lap along the boundary is driven last, so that the robot leaves it without crossing what it filled.
///
///   std::vector<Leg> legs = outline_last(fill, outer, width, free);
///
/// Planners drive the outermost lap as a detour from the lap inside it (lanes/outline.hpp), where their path also ends:
/// from there every transit crosses the outermost lap. The closed lap is cut out and driven at the path's end, or its
/// beginning, whichever is nearer to it. It covers the same. Nothing changes if the lap is not one closed part of a
/// leg, or if no straight line leads to it within three tool widths.
/// Source: ours. Complexity  O(n log n), and O(n) tests for each pass of a leg through its own points
#pragma once

#include <functional>
#include <vector>

#include "geometry/path.hpp"
#include "geometry/region.hpp"

namespace oxturn {

/// `outer`: the boundary that the tool's centre follows. `width`: the tool's, metres. `free`: whether the tool may be
/// driven along a straight line.
std::vector<Leg> outline_last(std::vector<Leg> legs, const Ring& outer, double width,
                              const std::function<bool(const Point&, const Point&)>& free);

}  // namespace oxturn
