// A polygonal footprint driven along a path, against the map's walls. Internal to metrics/.
//
// Each segment sweeps the convex hull of the footprint at both ends; a wall is hit if it meets the hull's inside, decided
// by exact predicates. Nothing is shared with the erosion that planners are given.
#pragma once

#include <optional>

#include "geometry/edge_index.hpp"
#include "geometry/path.hpp"

namespace oxturn {

struct FootprintHit {
  Point at;      // the robot's centre where it first hits something
  double depth;  // metres by which the footprint's sides would have to be nearer to the centre, on that segment
};
/// The first place at which the footprint, its sides drawn in by `tolerance`, has a wall inside. The path begins in free
/// space. O(m) exact tests for each wall near a segment, m corners.
std::optional<FootprintHit> first_hit(const Path& path, const Ring& footprint, double tolerance,
                                      const EdgeIndex& walls);

/// Least distance from the footprint to a wall along the path: how far its centre is from the border of the space where
/// it fits. Where a wall is inside it: minus the depth as above, or, of a centre outside free space, minus the distance to
/// free space and the whole in-radius.
double footprint_clearance(const Path& path, const Ring& footprint, const EdgeIndex& walls);

}  // namespace oxturn
