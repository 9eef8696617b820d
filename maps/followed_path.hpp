/// The path that a tether follows while its robot drives: where the tether lies at the start, and how far it can
/// follow.
///
///   TautTether tether = tether_at_start(problem);
///   tether.drive(followed_path(problem, path, problem.map_edges()).points);
#pragma once

#include "geometry/path.hpp"
#include "geometry/tether/taut_tether.hpp"
#include "maps/problem.hpp"

namespace oxturn {

/// The tether before the first move: from the anchor to the start along the geodesic. Tethered problems only. The
/// problem must outlive it.
TautTether tether_at_start(const Problem& problem);

struct FollowedPath {
  Polyline points;          // from the problem's start, transit included
  std::vector<Gear> gears;  // of the segments between them
  bool whole = true;  // false: the path jumps, starts elsewhere, leaves free space or is not finite; then `points` go
                      // up to there
  /// Legs of one gear each, the tool on.
  Path path() const;
};
/// `walls`: edges of the map's free space. Joints and walls are judged within `tolerance` metres; where that is more
/// than the problem's and the path runs within walls, the result runs along them. O(n), and once O(m log m) for m
/// vertices of the map if it does.
FollowedPath followed_path(const Problem& problem, const Path& path, const EdgeIndex& walls, double tolerance);

}  // namespace oxturn
