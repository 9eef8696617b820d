/// Fewer vertices for lines whose vertices lie closer together than their use can tell.
///
///   const Polyline line = thinned(leg.points, 1e-5);
///
/// Both lines have the same ends and are within `error` of each other. A segment replaces as many vertices as it passes
/// within `error`, if they lie ever farther from its start.
/// Source: the cone method of Williams, Computer Graphics and Image Processing 8, 1978. O(n) for n vertices.
#pragma once

#include "geometry/point.hpp"

namespace oxturn {

/// `error` in metres, above 0. Of a line of fewer than three points a copy.
Polyline thinned(const Polyline& line, double error);

/// Whether vertices are nearer to each other than `distance` on average.
bool is_dense(const Polyline& line, double distance);

}  // namespace oxturn
