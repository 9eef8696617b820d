/// Walls traced from images.
#pragma once

#include "geometry/region.hpp"

namespace oxturn {

/// Are the region's rings staircases, as those traced from images are? At least a quarter of their edges are steps:
/// shorter than `longest` metres, at right angles to the edges before and after, which lead away to different sides.
/// O(vertices).
bool is_staircase(const Region& region, double longest);

}  // namespace oxturn
