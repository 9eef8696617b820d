#include "algorithms/drawing/demands.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include "base/throw_invalid.hpp"

namespace oxturn {
namespace {

/// Of a stroke: how many nodes, and where the k-th one is in its points.
std::size_t node_count(const DrawingElement& e) { return e.nodes.empty() ? e.legs[0].points.size() : e.nodes.size(); }
std::size_t position(const DrawingElement& e, std::size_t k) { return e.nodes.empty() ? k : e.nodes[k]; }

void add_entry(DrawingElement& e, std::size_t at) {
  const auto next = std::lower_bound(e.entries.begin(), e.entries.end(), at);
  if (next == e.entries.end() || *next != at) e.entries.insert(next, at);
}

ElementPort stroke_port(std::vector<DrawingElement>& elements, std::size_t stroke, std::size_t k,
                        const NodeOfElement& node) {
  DrawingElement& e = elements[stroke];
  const std::size_t last = e.legs[0].points.size() - 1, at = position(e, k);
  if (e.closed) {
    add_entry(e, at % last);
    return {stroke, at % last};
  }
  if (at != 0 && at != last)
    throw_invalid("node {} of element '{}' is no end of its stroke; only ends can be connected", node.node,
                  node.element);
  return {stroke, at == 0 ? 0u : 1u};
}

/// The end of the element's fill that is nearer to the node of the area's boundary.
std::optional<ElementPort> fill_port(const std::vector<DrawingElement>& elements, const NodeOfElement& node) {
  std::optional<ElementPort> best;
  double least = 0;
  for (std::size_t e = 0; e < elements.size(); ++e) {
    if (elements[e].name != node.element || !elements[e].is_fill()) continue;
    const auto n = static_cast<std::ptrdiff_t>(elements[e].area->size());
    const Point& at = (*elements[e].area)[static_cast<std::size_t>(((node.node % n) + n) % n)];
    for (const std::size_t end : {0u, 1u}) {
      const double d = distance(at, end == 0 ? elements[e].first() : elements[e].last());
      if (!best || d < least) best = ElementPort{e, end}, least = d;
    }
  }
  return best;
}

/// Of a stroke its port; of an area without one all ends of its fills: a person saw one of them, but plans differ.
std::vector<ElementPort> all_ports_of(std::vector<DrawingElement>& elements, const NodeOfElement& node) {
  const ElementPort port = port_of(elements, node);
  if (!elements[port.element].is_fill()) return {port};
  std::vector<ElementPort> ports;
  for (std::size_t e = 0; e < elements.size(); ++e)
    if (elements[e].is_fill() && elements[e].name == node.element)
      for (const std::size_t end : {0u, 1u}) ports.push_back({e, end});
  return ports;
}

/// Joins elements as a person names them.
class JointMaker {
 public:
  using Joint = std::pair<ElementPort, ElementPort>;
  /// References must outlive it.
  JointMaker(std::vector<DrawingElement>& elements, std::vector<Joint>& joined)
      : elements_(elements), joined_(joined) {}

  /// The one that is there with these nodes or ports, if any, in this direction; else a new one.
  Joint make(const NodeOfElement& from, const NodeOfElement& to) {
    if (const auto named = made_.find({name(from), name(to)}); named != made_.end()) return named->second;
    const Joint nearest{port_of(elements_, from), port_of(elements_, to)}, turned{nearest.second, nearest.first};
    if (nearest.first.element == nearest.second.element || has(nearest) || has(turned)) return nearest;
    const Joint joint{free(nearest.first), free(nearest.second)};
    joined_.push_back(joint);
    made_[{name(from), name(to)}] = joint;
    made_[{name(to), name(from)}] = {joint.second, joint.first};
    return joint;
  }

 private:
  using Name = std::pair<std::string, int>;
  static Name name(const NodeOfElement& node) { return {node.element, node.node}; }
  bool has(const Joint& joint) const { return std::ranges::find(joined_, joint) != joined_.end(); }
  bool taken(const ElementPort& port) const {
    return std::ranges::any_of(joined_, [&](const Joint& j) { return j.first == port || j.second == port; });
  }
  /// Of a fill the other end, if only that is free.
  ElementPort free(const ElementPort& port) const {
    const ElementPort other{port.element, 1 - port.at};
    const bool has_other = elements_[port.element].is_fill() && !elements_[port.element].closed;
    return has_other && taken(port) && !taken(other) ? other : port;
  }

  std::vector<DrawingElement>& elements_;
  std::vector<Joint>& joined_;
  std::map<std::pair<Name, Name>, Joint> made_;
};

}  // namespace

ElementPort entry_port(const DrawingElement& element, const ElementVisit& visit) {
  return {visit.element, element.closed ? visit.entry : visit.backwards ? 1u : 0u};
}

ElementPort exit_port(const DrawingElement& element, const ElementVisit& visit) {
  return {visit.element, element.closed ? visit.entry : visit.backwards ? 0u : 1u};
}

ElementPort port_of(std::vector<DrawingElement>& elements, const NodeOfElement& node) {
  std::vector<std::size_t> strokes;
  std::ptrdiff_t count = 0;
  for (std::size_t e = 0; e < elements.size(); ++e)
    if (elements[e].name == node.element && !elements[e].is_fill()) {
      strokes.push_back(e);
      count += static_cast<std::ptrdiff_t>(node_count(elements[e]));
    }
  if (strokes.empty()) {
    if (const auto port = fill_port(elements, node)) return *port;
    throw_invalid("a connection names element '{}', but the drawing has no such stroke or filled area", node.element);
  }
  std::ptrdiff_t k = node.node < 0 ? count + node.node : node.node;
  if (k < 0 || k >= count)
    throw_invalid("a connection names node {} of element '{}', which has {} nodes", node.node, node.element, count);
  for (const std::size_t stroke : strokes) {
    const auto nodes = static_cast<std::ptrdiff_t>(node_count(elements[stroke]));
    if (k < nodes) return stroke_port(elements, stroke, static_cast<std::size_t>(k), node);
    k -= nodes;
  }
  throw_invalid("element '{}' has no node {}", node.element, node.node);
}

TourDemands demands_of(const Drawing& drawing, std::vector<DrawingElement>& elements) {
  TourDemands demands;
  JointMaker joints(elements, demands.joined);
  for (const DrawnConnection& c : drawing.connections) {
    const ElementPort from = port_of(elements, c.from), to = port_of(elements, c.to);
    if (from.element == to.element)
      throw_invalid("a connection leads from element '{}' to itself; expected two elements", c.from.element);
    if (c.enforced) {
      joints.make(c.from, c.to);
      continue;
    }
    for (const ElementPort& a : all_ports_of(elements, c.from))
      for (const ElementPort& b : all_ports_of(elements, c.to)) demands.deleted.push_back({a, b});
  }
  for (const DrawnCurve& c : drawing.curves) demands.by_hand.push_back(joints.make(c.from, c.to));
  for (const auto& joint : demands.joined)
    for (const auto& [a, b] : demands.deleted)
      if (joint == std::pair(a, b) || joint == std::pair(b, a))
        throw_invalid("the connection between elements '{}' and '{}' is both enforced and deleted",
                      elements[a.element].name, elements[b.element].name);
  return demands;
}

}  // namespace oxturn
