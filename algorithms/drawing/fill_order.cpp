#include "algorithms/drawing/fill_order.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/edge_index.hpp"

namespace oxturn {
namespace {

constexpr double kLap = 0.5;  // tool widths: strokes whose distances differ by less belong to one lap

std::vector<Leg> strokes_of(const DrawingElement& element) {
  std::vector<Leg> strokes;
  for (const Leg& leg : element.legs)
    if (leg.tool) strokes.push_back(leg);
  return strokes;
}

DrawingElement with_strokes(DrawingElement element, std::vector<Leg> strokes) {
  element.legs.clear();
  for (Leg& stroke : strokes) {
    if (!element.legs.empty())
      element.legs.push_back({false, {element.legs.back().points.back(), stroke.points.front()}});
    element.legs.push_back(std::move(stroke));
  }
  return element;
}

std::vector<Leg> turned_round(std::vector<Leg> strokes) {
  std::ranges::reverse(strokes);
  for (Leg& stroke : strokes) std::ranges::reverse(stroke.points);
  return strokes;
}

/// In laps, of a stroke's middle.
double depth(const Leg& stroke, const EdgeIndex& boundary, double width) {
  const auto nearest = boundary.nearest(stroke.points[stroke.points.size() / 2]);
  return nearest ? std::round(nearest->distance / (kLap * width)) : 0;
}

std::vector<Leg> innermost_first(std::vector<Leg> strokes, const Ring& outer, double width) {
  const EdgeIndex boundary(Region{{{outer, {}}}});
  std::vector<std::pair<double, std::size_t>> keys;
  for (std::size_t k = 0; k < strokes.size(); ++k) keys.push_back({-depth(strokes[k], boundary, width), k});
  std::ranges::sort(keys);
  std::vector<Leg> sorted;
  for (const auto& [key, k] : keys) sorted.push_back(std::move(strokes[k]));
  return sorted;
}

}  // namespace

DrawingElement best_order(const DrawingElement& element, double width,
                          const std::function<InnerPrice(const DrawingElement&)>& price) {
  const std::vector<Leg> strokes = strokes_of(element), turned = turned_round(strokes);
  DrawingElement best = element;
  InnerPrice least = price(element);
  if (least.first > 0)
    for (const std::vector<Leg>& order :
         {turned, innermost_first(strokes, *element.area, width), innermost_first(turned, *element.area, width)}) {
      DrawingElement other = with_strokes(element, order);
      if (const InnerPrice p = price(other); p < least) least = p, best = std::move(other);
    }
  best.one_way = price(with_strokes(element, turned_round(strokes_of(best)))).first > least.first;
  return best;
}

}  // namespace oxturn
