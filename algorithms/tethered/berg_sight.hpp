/// Wall corners and exact lines of sight between them, where gaps that the robot cannot pass are closed by barriers.
///
///   const BergSight sight(free, walls, barriers, tolerance);
///   sight.sees(anchor, sight.corners()[0].at);
///
/// Built in O(n log n). Cost: a test of sight O(grid cells crossed), of walls and of barriers.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "geometry/edge_index.hpp"
#include "geometry/mesh/mesh.hpp"
#include "geometry/region.hpp"

namespace oxturn {

class BergSight {
 public:
  /// A vertex of the walls. Free space lies counter-clockwise from `next` to `previous`. Where a barrier ends there is
  /// one corner on each side of it, where obstacles touch in a point one in each free wedge between them.
  struct Corner {
    Point at, previous, next;
    bool shares_point = false;  // with another corner, from which nothing is seen on this side
  };

  /// `walls` are the edges of `free` and must outlive it; `barriers` are segments between walls that act as walls.
  BergSight(const Region& free, const EdgeIndex& walls, const std::vector<Polyline>& barriers, double tolerance);

  const std::vector<Corner>& corners() const { return corners_; }
  /// For every point of `mesh`, which has the same walls and barriers, the corners there; where a barrier ends inside a
  /// wall, also the corners where that wall begins. Corners at none of the points are in an additional last list.
  std::vector<std::vector<std::uint32_t>> corners_at_points(const Mesh& mesh) const;
  /// Exact. Touching a corner does not block, unless the line of sight passes between the corner and a barrier that
  /// ends there, or between two obstacles that touch there.
  bool sees(const Point& eye, const Point& p) const;
  /// Can the corner be seen from `eye` as far as barriers that end there and other obstacles there are concerned?
  static bool open_towards(const Corner& corner, const Point& eye) {
    return !corner.shares_point || in_wedge(corner, eye);
  }

 private:
  struct Barrier {
    Point from, to;  // a little inside the wall where they do not end at a corner
  };
  struct BarrierEnd {  // at a corner
    Point at, other, previous, next;
  };
  static bool in_wedge(const Corner& corner, const Point& p);
  static bool met_before(const Point& at, const Point& from, const Point& a, const Point& b);
  static bool blocked_between(const std::vector<Corner>& contact, const Point& eye, const Point& p);
  static bool blocked_at(const BarrierEnd& end, const Point& eye, const Point& p);
  Point add_barrier_end(const Point& at, const Point& other);
  void add_corner(const Corner& corner);
  void separate_wedges(const std::vector<std::uint32_t>& corners);
  void split_corner(std::size_t k, const Point& other);

  const EdgeIndex& walls_;
  double tolerance_;
  std::vector<Corner> corners_;
  std::map<Point, std::vector<std::uint32_t>, decltype(&before)> corners_at_{&before};  // ascending
  std::vector<std::pair<Point, Point>> ends_in_walls_;  // of barriers; and where that wall begins
  std::vector<Barrier> barriers_;
  std::vector<BarrierEnd> barrier_ends_;
  std::vector<std::vector<Corner>> contacts_;  // where obstacles touch: the corners, before barriers split them
  UniformGrid barrier_grid_, end_grid_, contact_grid_;
};

}  // namespace oxturn
