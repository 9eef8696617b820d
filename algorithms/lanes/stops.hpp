/// Stops beside a path: positions from which the tool covers a small uncovered piece.
///
///   path = with_stops(path, start, pieces, 0.4995 * w, walls);      // `pieces` keeps those without a stop
///
///        S           The robot leaves the path where it passes the piece, goes towards it until the tool covers all
///       / \          of it, and comes back. Where the path turns and the piece lies outside of the turn, as at the
///      / V \         corners of laps, it leaves the path at A and comes back at B, without V:
///     A.---.B        nothing that the turn covered is lost, and the detour is shorter by a third.
///     |     |
///
/// Guarantee   the tool covers what it covered before, and the pieces that got a stop: let r be its reach, a the angle
///             between the segments at V, |AV| = |VB| <= r min(1, cot(a/2)), and S in the cone opposite to them. Then
///             every point within r of A V B or of V S is within r of A S B or of the rest of the two segments.
/// Complexity  O(n log n) for n segments, and for each piece those near by
#pragma once

#include <vector>

#include "geometry/edge_index.hpp"
#include "geometry/path.hpp"
#include "geometry/region.hpp"

namespace oxturn {

/// `reach`: metres from the robot's centre within which the tool covers. `walls`: those of configuration space.
Path with_stops(const Path& path, const Point& start, std::vector<Polygon>& pieces, double reach,
                const EdgeIndex& walls);

}  // namespace oxturn
