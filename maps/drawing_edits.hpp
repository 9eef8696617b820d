/// What a person has changed about a drawing: cuts of areas, fills, connections, curves, the start. Read from JSON.
///
///   const Drawing drawing = edited(from_svg.drawing, read_file("edits.json"), "edits.json");
///
/// docs/drawings.md has the format; the viewer writes it.
#pragma once

#include <string>

#include "maps/drawing.hpp"

namespace oxturn {

/// The drawing with the edits, in the order start, cuts, fills, connections, curves. Throws std::invalid_argument
/// "SOURCE: /fills/0/element: what is wrong" (a JSON pointer) for unknown keys and elements, contradictions, a cut that
/// cuts nothing, and edits of another drawing.
Drawing edited(Drawing drawing, const std::string& json, const std::string& source);

}  // namespace oxturn
