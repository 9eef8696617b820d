/// Short detours that cover small pieces beside a path.
///
///   path = with_stops(path, uncovered.polygons, enough, 0.499 * w, problem.walls());
///
///     ---->----.  .---->----        the robot leaves the path where it passes the piece, goes towards it until
///               \/                  the tool reaches all of it, and comes back
///               ()
///
/// Pieces that no single position covers, or that are behind walls, stay as they are. O(s + p) for s segments and
/// p pieces, if a piece is near to few segments.
#pragma once

#include <vector>

#include "geometry/edge_index.hpp"

namespace oxturn {

/// `enough`: square metres after which no more detours are made; those that are shortest for what they cover go first.
/// `reach`: metres from the robot's centre within which it covers. The path holds at least one point.
Polyline with_stops(const Polyline& path, const std::vector<Polygon>& pieces, double enough, double reach,
                    const EdgeIndex& walls);

}  // namespace oxturn
