/// Strokes that a drawing has more than once, in the same position.
///
///   for (const auto& copies : stroke_copies(elements)) ...      // copies.size() is 1 for most
///
/// Copies of an open stroke that are driven there and back cost nothing between them. So where there are more than two,
/// all or all but one of them may be driven one after the other: an odd number of them leads from one end to the other.
/// Complexity  O(n log n) comparisons of strokes for n elements
#pragma once

#include <vector>

#include "algorithms/drawing/element.hpp"

namespace oxturn {

struct StrokeCopy {
  std::size_t element = 0;
  bool turned = false;  // drawn in the opposite direction to the first one of the group
};

/// Every element in one group, with those that have the same points, in either direction if they are open, and the
/// same entries. Groups, and the elements in each, are in the elements' order. Fills, elements of several legs and
/// those that must be driven forwards are alone.
std::vector<std::vector<StrokeCopy>> stroke_copies(const std::vector<DrawingElement>& elements);

}  // namespace oxturn
