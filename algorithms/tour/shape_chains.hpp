/// Shapes that are joined by connections, as chains driven from one end to the other.
///
///   for (const ShapeChain& chain : chains_of(drawing)) { /* chain.front().shape ... */ }
#pragma once

#include "algorithms/tour/tour_shapes.hpp"

namespace oxturn {

/// Shapes in driving order. A polygon is entered and left at the same vertex.
struct ShapeLink {
  std::size_t shape, entry, exit;
};
using ShapeChain = std::vector<ShapeLink>;

/// One chain for each connected group of two or more shapes, from the end with the lower number. Throws as
/// ShapeTourModel does. O(shapes + joints).
std::vector<ShapeChain> chains_of(const ShapeTour& drawing);

}  // namespace oxturn
