#include "geometry/tether/branching_tether.hpp"

#include <algorithm>

#include "geometry/path.hpp"

namespace oxturn {

bool stays_within(TautTether tether, std::span<const Point> points, double longest) {
  return std::ranges::all_of(points, [&](const Point& p) {
    tether.drive(p);
    return tether.length() <= longest;
  });
}

bool BranchingTether::stays_within(const Polyline& points) {
  if (root_.tether.length() + length(points) <= longest_) return true;  // it grows by what is driven, at most
  Node* node = &root_;
  for (std::size_t k = 1; k < points.size(); ++k) {
    Node* const after = next(*node, points[k]);
    if (after == nullptr) return oxturn::stays_within(node->tether, std::span(points).subspan(k), longest_);
    if (after->too_long) return false;
    node = after;
  }
  return true;
}

BranchingTether::Node* BranchingTether::next(Node& node, const Point& to) {
  const auto known = std::ranges::find(node.next, to, [](const Node* n) { return n->tether.robot(); });
  if (known != node.next.end()) return *known;
  if (nodes_.size() == kMost) return nullptr;
  Node& added = nodes_.emplace_back(Node{.tether = node.tether});
  added.tether.drive(to);
  added.too_long = !(added.tether.length() <= longest_);
  node.next.push_back(&added);
  return &added;
}

}  // namespace oxturn
