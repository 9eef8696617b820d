// The path against the map's walls. Shared by validity and clearance; internal to metrics/.
#pragma once

#include <string>

#include "geometry/edge_index.hpp"
#include "geometry/path.hpp"
#include "maps/problem.hpp"

namespace oxturn {

/// "" if the path obeys every rule of score.hpp but that of the tether. `walls`: edges of the map's free space.
std::string find_flaw(const Problem& problem, const Path& path, const EdgeIndex& walls);
/// See clearance.cpp. Where the path is outside free space, its depth is taken at its points.
double clearance(const Problem& problem, const Path& path, const EdgeIndex& walls);

}  // namespace oxturn
