/// Tacking: driving against the pull of the tether in strokes at an angle, as a boat sails against the wind.
///
///   path = tacked(space, path, 0.8, tool_width / 4);     // at least 0.8 rad between heading and pull
///
///                .           .
///              .   .       .   .
///    pull <-- . - - . - - . - - . -- the segment of the path, driven towards the pull
///                     . .
#pragma once

#include "algorithms/transit/tether_space.hpp"

namespace oxturn {

/// Replaces every segment whose heading is nearer than `angle` (radians) to the direction of the tether's pull by
/// strokes at that angle to the pull, at most `width` metres to either side of the segment. Segments without room for
/// that stay. The path must not leave the cut space: the tether is the geodesic everywhere. O(n + strokes) queries of
/// the field.
Path tacked(const TetherSpace& space, const Path& path, double angle, double width);

}  // namespace oxturn
