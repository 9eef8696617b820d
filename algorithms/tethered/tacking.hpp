// Driving against the pull of the string without folding it sharply: tacking, as a boat does against the wind.
#pragma once

#include "algorithms/transit/tether_space.hpp"

namespace oxturn {

/// The path with every stretch whose heading is nearer than `angle` (radians) to the string's pull replaced by strokes at
/// that angle to it, on either side of the stretch, at most `width` to the side. Stretches without room for that stay.
/// The path must not leave the cut space: the string is the geodesic everywhere. O(n + strokes) questions to the field.
Path tacked(const TetherSpace& leash, const Path& path, double angle, double width);

}  // namespace oxturn
