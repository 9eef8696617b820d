#include "geometry/tether/branching_tether.hpp"

#include <algorithm>

#include "geometry/path.hpp"

namespace oxturn {

bool BranchingTether::stays_within(const Polyline& points) {
  if (root_.tether.length() + length(points) <= longest_) return true;  // it grows by what is driven, at most
  Node* node = &root_;
  std::size_t k = 1;
  for (; k < points.size(); ++k) {
    Node* const after = next(*node, points[k]);
    if (after == nullptr) break;
    if (after->too_long) return false;
    node = after;
  }
  if (k == points.size()) return true;
  TautTether tether = node->tether;
  for (; k < points.size(); ++k) {
    tether.drive(points[k]);
    if (!(tether.length() <= longest_)) return false;
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
