#include "algorithms/drawing/followed_strokes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/math.hpp"

namespace oxturn {
namespace {

using Joint = std::pair<ElementPort, ElementPort>;

double deflection(const Polyline& ring, std::size_t k) {
  const Point &at = ring[k], &before = ring[k == 0 ? ring.size() - 2 : k - 1], &after = ring[k + 1];
  return std::abs(math::atan2(cross(at - before, after - at), (at - before).dot(after - at)));
}

/// Ports of closed strokes that are opened become ends of them.
class Opened {
 public:
  Opened(std::vector<DrawingElement>& elements, const TourDemands& demands) : elements_(elements) {
    for (const auto& [a, b] : demands.joined)
      for (const ElementPort& port : {a, b})
        if (elements[port.element].closed) named_[port.element].insert(port.at);
  }

  /// At the only node that is connected, or at `at`. False: connected at several, which is an error of its own.
  bool open(std::size_t element, std::size_t at) {
    const auto named = named_.find(element);
    if (named != named_.end() && named->second.size() > 1) return false;
    if (named != named_.end()) at = *named->second.begin();
    DrawingElement& e = elements_[element];
    e.legs = driven(e, {element, at, false});
    e.closed = false;
    e.entries.clear();
    opened_[element] = at;
    return true;
  }

  void change(TourDemands& demands, PortCurves& curves) {
    std::map<Joint, Joint> changed;
    for (Joint& joint : demands.joined) {
      const Joint before = joint;
      joint = {end_of(joint.first), end_of(joint.second)};
      changed[before] = joint;
      changed[{before.second, before.first}] = {joint.second, joint.first};
    }
    PortCurves moved;
    for (auto& [joint, curve] : curves) {
      const auto to = changed.find(joint);
      moved.insert({to == changed.end() ? joint : to->second, std::move(curve)});
    }
    curves = std::move(moved);
    std::vector<Joint> deleted;
    for (const auto& [a, b] : demands.deleted)
      for (const ElementPort& p : both_ends(a))
        for (const ElementPort& q : both_ends(b)) deleted.push_back({p, q});
    demands.deleted = std::move(deleted);
  }

 private:
  /// Of the two connections of a closed stroke one leads to its first point, the other one from its last.
  ElementPort end_of(const ElementPort& port) {
    if (opened_.count(port.element) == 0) return port;
    return {port.element, used_[port.element]++ == 0 ? 0u : 1u};
  }
  /// None if it is entered elsewhere.
  std::vector<ElementPort> both_ends(const ElementPort& port) const {
    const auto found = opened_.find(port.element);
    if (found == opened_.end()) return {port};
    if (found->second != port.at) return {};
    return {{port.element, 0}, {port.element, 1}};
  }

  std::vector<DrawingElement>& elements_;
  std::map<std::size_t, std::set<std::size_t>> named_;
  std::map<std::size_t, std::size_t> opened_;  // where, by element
  std::map<std::size_t, int> used_;            // ends of opened ones
};

/// With transits between them.
std::vector<Leg> legs_of(std::vector<Polyline> pieces, const Leg& stroke) {
  std::vector<Leg> legs;
  for (Polyline& piece : pieces) {
    if (!legs.empty()) legs.push_back({.tool = false, .points = {piece.front(), piece.front()}});
    legs.push_back(stroke);
    legs.back().points = std::move(piece);
  }
  return legs;
}

}  // namespace

void follow_strokes(std::vector<DrawingElement>& elements, TourDemands& demands, PortCurves& curves,
                    const FollowOptions& options) {
  Opened opened(elements, demands);
  for (std::size_t k = 0; k < elements.size(); ++k) {
    DrawingElement& e = elements[k];
    if (e.is_fill()) continue;
    const std::vector<std::size_t> sharp = sharp_vertices(e.legs[0].points, e.closed, options);
    if (!sharp.empty() && e.closed) {
      const Polyline& ring = e.legs[0].points;
      const std::size_t at = *std::ranges::max_element(sharp, {}, [&](std::size_t v) { return deflection(ring, v); });
      if (!opened.open(k, at)) continue;
    }
    e.followed = true;
    if (sharp.empty()) continue;
    e.legs = legs_of(followed_line(e.legs[0].points, options), Leg(e.legs[0]));
    e.nodes.clear();
    e.corners.clear();
  }
  opened.change(demands, curves);
}

}  // namespace oxturn
