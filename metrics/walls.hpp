/// A path against the walls of the map, for validity and clearance. Private to metrics/.
#pragma once

#include <string>

#include "geometry/edge_index.hpp"
#include "geometry/path.hpp"
#include "maps/problem.hpp"

namespace oxturn {

/// The first rule of score.hpp that the path breaks by more than `tolerance` metres, except that of the tether; "" if
/// it breaks none. `walls`: edges of the map's free space.
std::string find_flaw(const Problem& problem, const Path& path, const EdgeIndex& walls, double tolerance);
/// The metric clearance_m. Where the path is outside free space, its depth is measured at its points only.
double clearance(const Problem& problem, const Path& path, const EdgeIndex& walls);

}  // namespace oxturn
