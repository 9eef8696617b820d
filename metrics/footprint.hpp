/// A polygonal footprint that moves along a path, against the walls of the map. Private to metrics/.
///
///   if (const auto hit = first_hit(path, robot.footprint, tolerance, walls)) complain(hit->at, hit->depth);
///
/// On each segment the footprint sweeps the convex hull of its first and its last position. A wall is hit if it meets
/// the interior of that hull, by exact predicates. Shares nothing with the erosion from which planners get
/// configuration space.
#pragma once

#include <optional>

#include "geometry/edge_index.hpp"
#include "geometry/path.hpp"

namespace oxturn {

struct FootprintHit {
  Point at;      // the robot's centre where the footprint first hits a wall
  double depth;  // metres by which the footprint's sides would have to be nearer to the centre, on that segment
};
/// The first point of the path at which a wall meets the interior of the footprint with its sides moved inwards by
/// `tolerance`. The path must begin in free space. O(m) exact tests per wall near a segment, for m vertices.
std::optional<FootprintHit> first_hit(const Path& path, const Ring& footprint, double tolerance,
                                      const EdgeIndex& walls);

/// Least distance between the footprint and a wall along the path, metres: the distance of its centre from the boundary
/// of the space where it fits. If a wall meets the interior, minus the depth as above; if the centre is outside free
/// space, minus its distance from free space and minus the in-radius.
double footprint_clearance(const Path& path, const Ring& footprint, const EdgeIndex& walls);

}  // namespace oxturn
