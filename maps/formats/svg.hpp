// Pictures of a bare map, and what text needs to stand in a picture or a page. Pictures of problems and paths are declared
// in maps/formats.hpp.
#pragma once

#include <string>

#include "maps/formats.hpp"

namespace oxturn {

/// SVG of the free space on grey walls, with a scale bar. No robot, no start.
std::string to_svg(const Map& map, const PictureOptions& options = {});

/// Text made fit for XML and HTML, attributes included; control characters become spaces.
std::string escape_xml(const std::string& text);

}  // namespace oxturn
