/// Moves the parts of a path that run along walls exactly onto them.
///
///   const WallFollowing walls(problem.walls());
///   path = walls.snapped(path, 0.05 * tool_width);
///
///   ______________       A path that annealing leaves is slightly off the walls and covers all but a seam along
///   --.___.--.__.-       them. Edges whose ends are both near the wall become the part of the boundary between these
///                        ends, if that runs beside the edge; round corners, all of their vertices.
///
/// Complexity  O(n log n) once for n edges of walls; O(1) for each edge of the path and each vertex of walls beside it
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/edge_index.hpp"

namespace oxturn {

class WallFollowing {
 public:
  /// `walls` must outlive it.
  explicit WallFollowing(const EdgeIndex& walls);
  /// The path with edges along walls replaced. Its ends stay. `tolerance`: metres.
  Polyline snapped(const Polyline& path, double tolerance) const;

 private:
  struct OnWall {
    Point point;
    std::size_t edge;
  };
  std::optional<OnWall> foot(const Point& p, double tolerance) const;
  std::optional<Polyline> beside(const OnWall& from, const OnWall& to, double tolerance) const;
  std::optional<Polyline> walk(const OnWall& from, const OnWall& to, double tolerance, bool forward) const;

  const EdgeIndex& walls_;
  std::vector<std::size_t> next_, previous_;  // edges of the same ring
};

}  // namespace oxturn
