/// The obstacle corners about which a tether can bend, in a grid: those where there is more than 180 degrees of free
/// space.
///
///   const TautSpace space(free_space);
///   space.for_each_near(triangle, 0.0, [&](const TautSpace::Corner& c) { /* c may lie in the triangle */ });
///
/// Build O(n log n), memory O(n). A query costs the cells that it visits. Immutable; shared by any number of tethers
/// and threads.
#pragma once

#include "geometry/region.hpp"
#include "geometry/uniform_grid.hpp"

namespace oxturn {

class TautSpace {
 public:
  /// A wedge of obstacle of less than 180 degrees. Where rings touch, every wedge between two fans of free space is a
  /// corner of its own, so there can be several at one point.
  struct Corner {
    Point at;
    Point inside;  // seen from `at`, a point strictly between the wedge's two walls
  };
  /// Metres by which points of a path may lie inside a wall. Corners nearer than twice that to the next one of their
  /// ring are left out: they could not be passed in a definite order.
  static constexpr double kNear = 2e-6;

  explicit TautSpace(const Region& free);

  /// Calls f(corner) for every corner within `pad` of a segment or a convex polygon, given by its vertices; also for
  /// some others near it, and for some repeatedly.
  template <class F>
  void for_each_near(std::span<const Point> vertices, double pad, F f) const {
    grid_.visit_items(vertices, pad, [&](std::uint32_t i) {
      f(corners_[i]);
      return false;
    });
  }

 private:
  std::vector<Corner> corners_;
  UniformGrid grid_;
};

}  // namespace oxturn
