/// The obstacle corners about which a tether can bend, in a grid. Private to geometry, not installed.
///
///   const CornerIndex index(free_space);
///   index.for_each_near(triangle, 3, 0.0, [&](const CornerIndex::Corner& c) { /* c may lie in the triangle */ });
///
/// Build O(n log n), memory O(n). A query costs the cells that it visits. Immutable after construction.
#pragma once

#include <vector>

#include "geometry/region.hpp"
#include "geometry/uniform_grid.hpp"

namespace oxturn {

class CornerIndex {
 public:
  /// A wedge of obstacle of less than 180 degrees. Where rings touch, every wedge between two fans of free space is a
  /// corner of its own, so there can be several at one point.
  struct Corner {
    Point at;
    Point inside;  // seen from `at`, a point strictly between the wedge's two walls
  };
  explicit CornerIndex(const Region& free);

  const std::vector<Corner>& corners() const { return corners_; }
  /// Calls f(corner) for every corner within `pad` of the convex polygon of n vertices (n = 2: a segment); also for
  /// some others near it, and for some repeatedly.
  template <class F>
  void for_each_near(const Point* polygon, int n, double pad, F f) const {
    grid_.visit(polygon, n, pad, [&](std::size_t cell) {
      for (const std::uint32_t i : grid_.items(cell)) f(corners_[i]);
      return false;
    });
  }

 private:
  std::vector<Corner> corners_;
  UniformGrid grid_;
};

}  // namespace oxturn
