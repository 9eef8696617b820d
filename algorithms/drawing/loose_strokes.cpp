#include "algorithms/drawing/loose_strokes.hpp"

#include <algorithm>

namespace oxturn {
namespace {

constexpr std::size_t kMostPairs = 1'000'000;

using Joints = std::vector<std::pair<ElementPort, ElementPort>>;

std::vector<bool> named_by_a_person(const TourDemands& demands, std::size_t elements) {
  std::vector<bool> named(elements, false);
  for (const Joints* joints : {&demands.joined, &demands.deleted, &demands.by_hand})
    for (const auto& [a, b] : *joints) named[a.element] = named[b.element] = true;
  return named;
}

/// Each second leg is a stroke with the tool on.
bool can_be_loose(const DrawingElement& e) {
  if (e.closed || !e.followed || e.legs.size() < 3 || e.legs.size() % 2 == 0) return false;
  for (std::size_t k = 0; k < e.legs.size(); ++k)
    if (e.legs[k].tool != (k % 2 == 0)) return false;
  return true;
}

DrawingElement stroke_of(const DrawingElement& whole, const Leg& leg) {
  DrawingElement e{.name = whole.name, .legs = {leg}, .area = whole.area};
  e.followed = true;
  return e;
}

}  // namespace

LooseStrokes::LooseStrokes(const std::vector<DrawingElement>& whole, const TourDemands& given,
                           const PortCurves& of_whole) {
  const std::vector<bool> named = named_by_a_person(given, whole.size());
  const auto strokes = [&](std::size_t e) {
    return named[e] || !can_be_loose(whole[e]) ? std::size_t{1} : (whole[e].legs.size() + 1) / 2;
  };
  std::size_t pairs = 0;
  for (const auto& [outer, inner] : given.contained) pairs += strokes(outer) * strokes(inner);
  for (std::size_t e = 0; e < whole.size(); ++e) {
    first_.push_back(elements.size());
    if (pairs > kMostPairs || strokes(e) == 1)
      elements.push_back(whole[e]);
    else
      for (std::size_t k = 0; k < whole[e].legs.size(); k += 2)
        elements.push_back(stroke_of(whole[e], whole[e].legs[k]));
  }
  first_.push_back(elements.size());

  demands.containment = given.containment;
  const auto moved = [&](const ElementPort& port) { return ElementPort{first_[port.element], port.at}; };
  for (const auto& [from, to] : {std::pair(&given.joined, &demands.joined),
                                 {&given.deleted, &demands.deleted},
                                 {&given.by_hand, &demands.by_hand}})
    for (const auto& [a, b] : *from) to->push_back({moved(a), moved(b)});
  for (const auto& [outer, inner] : given.contained)
    for (std::size_t o = first_[outer]; o < first_[outer + 1]; ++o)
      for (std::size_t i = first_[inner]; i < first_[inner + 1]; ++i) demands.contained.push_back({o, i});
  for (const auto& [joint, curve] : of_whole) curves.insert({{moved(joint.first), moved(joint.second)}, curve});
}

std::vector<ElementVisit> LooseStrokes::order(const std::vector<ElementVisit>& of_whole) const {
  std::vector<ElementVisit> order;
  for (ElementVisit visit : of_whole) {
    const std::size_t first = first_[visit.element], end = first_[visit.element + 1];
    for (std::size_t k = first; k < end; ++k) {
      visit.element = visit.backwards ? first + end - 1 - k : k;
      order.push_back(visit);
    }
  }
  return order;
}

}  // namespace oxturn
