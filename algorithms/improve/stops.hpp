/// Short detours that cover small pieces beside a path.
///
///   path = with_stops(path, uncovered.polygons, 0.499 * w, problem.walls());
///
///     ---->----.  .---->----        the robot leaves the path where it passes the piece, goes towards it until
///               \/                  the tool reaches all of it, and comes back
///               ()
///
/// Pieces that no single position covers, or that are behind walls, stay as they are. O(s p) for s segments and p
/// pieces.
#pragma once

#include <vector>

#include "geometry/edge_index.hpp"

namespace oxturn {

/// `reach`: metres from the robot's centre within which it covers. The path holds at least one point.
Polyline with_stops(const Polyline& path, const std::vector<Polygon>& pieces, double reach, const EdgeIndex& walls);

}  // namespace oxturn
