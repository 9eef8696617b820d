/// The strokes of fills, and the pieces of strokes that bend too sharply, as elements of their own.
///
///   const LooseStrokes loose(elements, demands, curves);
///   order = loose.order(driven.order);                 // over loose.elements, which draw the same in the same order
///
/// A robot with a least turning radius leaves a fill between its strokes for loops. Whether these cross finished work
/// depends on which strokes of this fill, and of others beside it, come first; so in the end strokes are ordered, not
/// fills. Elements with connections or curves of a person stay whole, as do those whose tool is up somewhere.
/// What each element draws is the same as before and in the same order: pieces_of() does not change.
/// Source: ours. Complexity: linear, and the product of the strokes of each two elements one inside the other; if these
/// are more than a million, nothing is taken apart.
#pragma once

#include <vector>

#include "algorithms/drawing/demands.hpp"
#include "algorithms/drawing/order_driver.hpp"

namespace oxturn {

class LooseStrokes {
 public:
  LooseStrokes(const std::vector<DrawingElement>& whole, const TourDemands& demands, const PortCurves& curves);

  std::vector<DrawingElement> elements;
  TourDemands demands;
  PortCurves curves;

  /// The same order of strokes.
  std::vector<ElementVisit> order(const std::vector<ElementVisit>& of_whole) const;

 private:
  std::vector<std::size_t> first_;  // of the elements that make up each whole one
};

}  // namespace oxturn
