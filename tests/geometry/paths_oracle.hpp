// Oracle for shortest paths: visibility graph over all corners, then Dijkstra. Shares nothing with the mesh.
//
// Where rings touch, free space about a corner falls into several sectors, and no path leads from one to another
// through the corner. So a node is a sector of a corner.
#pragma once

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/edge_index.hpp"
#include "geometry/predicates.hpp"
#include "geometry/region.hpp"

namespace oxturn {

class PathsOracle {
 public:
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  /// O(n^3).
  explicit PathsOracle(const Region& region) : index_(region) {
    for_each_ring(region, [&](const Ring& r) { corners_.insert(corners_.end(), r.begin(), r.end()); });
    std::sort(corners_.begin(), corners_.end(), [](const Point& a, const Point& b) { return before(a, b); });
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    for (const Point& at : corners_) {
      const std::size_t first = nodes_.size();
      add_sectors(at);
      if (nodes_.size() > first + 1) pinches_.push_back(at);
    }
    arcs_.resize(nodes_.size());
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (const double d = straight(nodes_[i], nodes_[j]); d < kFar) {
          arcs_[i].emplace_back(j, d);
          arcs_[j].emplace_back(i, d);
        }
  }

  /// Shortest distances from a to all nodes. O(n^2).
  std::vector<double> from(const Point& a) const {
    std::vector<double> far(nodes_.size(), kFar);
    std::vector<bool> done(nodes_.size(), false);
    for (std::size_t i = 0; i < nodes_.size(); ++i) far[i] = straight(nodes_[i], a);
    while (true) {
      std::size_t at = nodes_.size();
      for (std::size_t i = 0; i < nodes_.size(); ++i)
        if (!done[i] && far[i] < kFar && (at == nodes_.size() || far[i] < far[at])) at = i;
      if (at == nodes_.size()) return far;
      done[at] = true;
      for (const auto& [next, d] : arcs_[at]) far[next] = std::min(far[next], far[at] + d);
    }
  }
  /// From a to b; `far` is from(a).
  double between(const std::vector<double>& far, const Point& a, const Point& b) const {
    double best = looks(a, b) ? oxturn::distance(a, b) : kFar;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (far[i] < best) best = std::min(best, far[i] + straight(nodes_[i], b));
    return best;
  }

  const EdgeIndex& index() const { return index_; }
  const std::vector<Point>& corners() const { return corners_; }
  /// Corners about which free space is in several sectors.
  const std::vector<Point>& pinches() const { return pinches_; }

 private:
  struct Node {
    Point at, right, left;  // free space is what a ray from `right`, turning counter-clockwise to `left`, passes
  };

  /// Is the direction to p in the closed sector?
  static bool within(const Node& n, const Point& p) {
    const int width = orientation(n.at, n.right, n.left);
    if (width > 0) return orientation(n.at, n.right, p) >= 0 && orientation(n.at, p, n.left) >= 0;
    if (width < 0) return !(orientation(n.at, n.left, p) > 0 && orientation(n.at, p, n.right) > 0);
    return (n.right - n.at).dot(n.left - n.at) > 0 || orientation(n.at, n.right, p) >= 0;
  }
  void add_sectors(const Point& at) {
    std::vector<Point> rights, lefts;  // free space is to the left of an edge
    for (const EdgeIndex::Edge& e : index_.edges()) {
      if (!on_segment(at, e.a, e.b)) continue;
      if (at != e.b) rights.push_back(e.b);
      if (at != e.a) lefts.push_back(e.a);
    }
    for (const Point& right : rights) {
      const Point* left = nullptr;
      for (const Point& p : lefts)
        if (left == nullptr || within({at, right, *left}, p)) left = &p;
      nodes_.push_back({at, right, *left});
    }
  }
  bool looks(const Point& a, const Point& b) const {
    return index_.contains(a, b) && std::none_of(pinches_.begin(), pinches_.end(), [&](const Point& p) {
             return p != a && p != b && on_segment(p, a, b);
           });
  }
  double straight(const Node& n, const Point& p) const {
    if (n.at == p) return 0;
    return within(n, p) && looks(n.at, p) ? oxturn::distance(n.at, p) : kFar;
  }
  double straight(const Node& a, const Node& b) const {
    if (a.at == b.at || !within(b, a.at)) return kFar;
    return straight(a, b.at);
  }

  EdgeIndex index_;
  std::vector<Point> corners_, pinches_;
  std::vector<Node> nodes_;
  std::vector<std::vector<std::pair<std::size_t, double>>> arcs_;
};

}  // namespace oxturn
