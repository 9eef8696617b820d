/// Tacking: driving against the pull of the tether in strokes at an angle, as a boat sails against the wind.
///
///   path = tacked(space.field(), component.problem, path, {.angle = 0.8, .width = tool_width});
///
///                .           .
///              .   .       .   .
///    pull <-- . - - . - - . - - . -- the segment of the path, driven towards the pull
///                     . .
#pragma once

#include "algorithms/transit/tether_space.hpp"

namespace oxturn {

struct Tacking {
  double angle = 0;  // least one between the heading and the direction of the tether's pull, radians
  double width = 0;  // of the strokes, metres to either side of the path, at most
};

/// Replaces whatever is driven nearer than `angle` to the direction of the tether's pull by strokes at that angle. What
/// covers (tool on) is driven exactly in between, outwards: in by strokes, back out along the path, and in again. Parts
/// without room for strokes stay, and so do those outside `component`, of the cut space, in which the tether is the
/// geodesic of `field`. O(n + strokes) queries of the field.
Path tacked(const GeodesicField& field, const Problem& component, const Path& path, const Tacking& tacking);

}  // namespace oxturn
