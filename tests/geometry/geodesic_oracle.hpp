// Geodesic distances by a visibility graph over all corners: O(n^2) straight looks, then Dijkstra. Shares nothing with
// the mesh and its cones.
#pragma once

#include <limits>
#include <vector>

#include "base/random.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/region.hpp"

namespace oxturn {

class GeodesicOracle {
 public:
  GeodesicOracle(const Region& region, const Point& anchor) : index_(region), nodes_{anchor} {
    for_each_ring(region, [&](const Ring& r) { nodes_.insert(nodes_.end(), r.begin(), r.end()); });
    far_.assign(nodes_.size(), kFar);
    from_.assign(nodes_.size(), 0);
    std::vector<bool> done(nodes_.size(), false);
    far_[0] = 0;
    while (true) {
      std::size_t at = nodes_.size();
      for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (!done[i] && far_[i] < kFar && (at == nodes_.size() || far_[i] < far_[at])) at = i;
      }
      if (at == nodes_.size()) return;
      done[at] = true;
      for (std::size_t i = 0; i < nodes_.size(); ++i) {
        const double d = far_[at] + oxturn::distance(nodes_[at], nodes_[i]);
        if (done[i] || d >= far_[i] || !index_.contains(nodes_[at], nodes_[i])) continue;
        far_[i] = d;
        from_[i] = at;
      }
    }
  }
  double distance(const Point& p) const {
    double best = kFar;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const double d = far_[i] + oxturn::distance(nodes_[i], p);
      if (d < best && index_.contains(nodes_[i], p)) best = d;
    }
    return best;
  }
  const EdgeIndex& index() const { return index_; }
  Point free_point(Rng& rng, const Box& box) const {
    while (true) {
      const Point p(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
      if (index_.contains(p)) return p;
    }
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
  EdgeIndex index_;
  std::vector<Point> nodes_;
  std::vector<double> far_;
  std::vector<std::size_t> from_;
};

}  // namespace oxturn
