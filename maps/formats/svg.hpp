// Pictures of a bare map; pictures of problems and paths are declared in maps/formats.hpp.
#pragma once

#include <string>

#include "maps/formats.hpp"

namespace oxturn {

/// SVG of the free space on grey walls, with a scale bar. No robot, no start.
std::string to_svg(const Map& map, const PictureOptions& options = {});

}  // namespace oxturn
