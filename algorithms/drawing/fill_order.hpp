/// The order of the strokes of a fill for a robot with a least turning radius.
///
///   const FillOrder best = best_order(element, price);
///
/// Such a robot leaves the lanes of a fill for loops at corners. Outside of a lap they cross what is not drawn yet if
/// laps are driven from the inside to the outside. So the strokes are tried in three orders: as planned, from the last
/// to the first, and by their distance from the area's boundary, innermost first; the cheapest one is taken.
/// Source: ours. Complexity: five times the transits inside the fill.
#pragma once

#include <functional>
#include <utility>

#include "algorithms/drawing/element.hpp"

namespace oxturn {

/// Metres over finished work, and metres, of the transits inside an element that is driven forwards.
using InnerPrice = std::pair<double, double>;

/// The element with its strokes in the best of these orders; in their own if no transit crosses finished work. One-way
/// if its transits cross more of it in the opposite direction. Connections between strokes are straight placeholders.
/// `width`: the tool's, metres.
DrawingElement best_order(const DrawingElement& element, double width,
                          const std::function<InnerPrice(const DrawingElement&)>& price);

}  // namespace oxturn
