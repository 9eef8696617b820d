/// Takes strokes out of a path whose area the rest of it covers as well.
///
///   driven = without_needless_strokes(std::move(driven), problem.target(), width, space, context);
///
/// A stroke inserted early is often covered by those inserted later, and by links. The strokes that may save most
/// metres are tried first: the path goes from the stroke before straight to the one behind, by a simple link. What
/// that uncovers is counted on a raster (improve/witnesses.hpp): a stroke is taken out if no point of it is lost.
/// Guarantee   no longer than before; what lies between points of the raster may be uncovered: check the area
/// Complexity  O(A / w^2) bytes for a box of area A; at most three tries for each stroke, each of which costs a simple
///             link and its length in the raster
#pragma once

#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/smoothing/linked_strokes.hpp"
#include "geometry/region.hpp"

namespace oxturn {

/// `width`: of the tool. Ends early if cancelled. `tries`, if given, is how many strokes were tried.
std::vector<LinkedStroke> without_needless_strokes(std::vector<LinkedStroke> driven, const Region& target, double width,
                                                   const CarSpace& space, const Context& context,
                                                   std::size_t* tries = nullptr);

}  // namespace oxturn
