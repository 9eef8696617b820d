// The obstacle corners that a string can bend about, in a grid. Private to geometry: not installed.
#pragma once

#include <vector>

#include "geometry/uniform_grid.hpp"
#include "geometry/region.hpp"

namespace oxturn {

/// Build O(n log n), memory O(n). Questions look at the cells they touch. Immutable after construction.
class CornerIndex {
 public:
  /// A wedge of obstacle with less than 180 degrees. Where rings touch, each wedge between two fans of free space counts
  /// by itself: several corners at one place.
  struct Corner {
    Point at;
    Point inside;  // seen from `at`, strictly between the wedge's two walls
  };
  explicit CornerIndex(const Region& free);

  const std::vector<Corner>& corners() const { return corners_; }
  /// Calls f(corner) for every corner within `pad` of the convex polygon of n points (a segment for n = 2); for others
  /// near it too, and for some more than once.
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
