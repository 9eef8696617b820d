/// Strokes with a part erased. Private to maps.
///
///   std::vector<DrawnStroke> left = pieces_outside(stroke, EdgeIndex(white));
#pragma once

#include "geometry/edge_index.hpp"
#include "maps/drawing.hpp"

namespace oxturn {

/// The parts of a stroke outside a region, in order. A closed stroke that is cut elsewhere than at its first point
/// gives one piece over that point. O(points + edges nearby).
std::vector<DrawnStroke> pieces_outside(const DrawnStroke& stroke, const EdgeIndex& region);

}  // namespace oxturn
