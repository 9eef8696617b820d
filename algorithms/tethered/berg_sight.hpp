/// Wall corners and exact lines of sight between them, where gaps that the robot cannot pass are closed by barriers.
///
///   const BergSight sight(free, walls, barriers, tolerance);
///   sight.sees(anchor, sight.corners()[0].at);
///
/// Cost: a test of sight O(grid cells crossed + barriers).
#pragma once

#include <vector>

#include "geometry/edge_index.hpp"
#include "geometry/region.hpp"

namespace oxturn {

class BergSight {
 public:
  /// A vertex of the walls. Free space lies counter-clockwise from `next` to `previous`. Where a barrier ends there is
  /// one corner on each side of it.
  struct Corner {
    Point at, previous, next;
    bool at_barrier = false;
  };

  /// `walls` are the edges of `free` and must outlive it; `barriers` are segments between walls that act as walls.
  BergSight(const Region& free, const EdgeIndex& walls, const std::vector<Polyline>& barriers, double tolerance);

  const std::vector<Corner>& corners() const { return corners_; }
  /// Exact. Touching a corner does not block, unless the line of sight passes between the corner and a barrier that
  /// ends there.
  bool sees(const Point& eye, const Point& p) const;
  /// Can the corner be seen from `eye` as far as barriers that end there are concerned?
  static bool open_towards(const Corner& corner, const Point& eye) {
    return !corner.at_barrier || in_wedge(corner, eye);
  }

 private:
  struct Barrier {
    Point from, to;  // a little inside the wall where they do not end at a corner
  };
  struct BarrierEnd {  // at a corner
    Point at, other, previous, next;
  };
  static bool in_wedge(const Corner& corner, const Point& p);
  Point add_barrier_end(const Point& at, const Point& other);
  void split_corner(std::size_t k, const Point& other);

  const EdgeIndex& walls_;
  double tolerance_;
  std::vector<Corner> corners_;
  std::vector<Barrier> barriers_;
  std::vector<BarrierEnd> barrier_ends_;
};

}  // namespace oxturn
