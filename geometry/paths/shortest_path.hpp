/// Shortest paths inside a region, among its holes.
///
///   const ShortestPaths paths(space, tolerance);
///   const std::optional<Polyline> p = paths.path(from, to);     // nullopt: not connected
///
/// Source      Cui, Harabor and Grastien, "Compromise-free pathfinding on a navigation mesh" (Polyanya), IJCAI 2017
/// Method      A* over intervals of triangle edges. Nothing is prepared but the triangulation: O(n log n) for n
///             vertices. In components without holes the funnel of the only sleeve of triangles is taken at once
///             (dual_tree.hpp).
/// Complexity  the cost of a query usually grows with the triangles between the ends, not with the region
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "geometry/mesh/mesh.hpp"

namespace oxturn {

class ShortestPaths {
 public:
  /// Ends of paths that lie outside the region by at most `tolerance` are moved to the nearest point of its boundary.
  /// Throws std::invalid_argument for a negative tolerance.
  ShortestPaths(const Region& region, double tolerance);
  /// The same for a region that is meshed already.
  ShortestPaths(Mesh mesh, double tolerance);

  /// The shortest path from a to b, both included, optimal up to the rounding of lengths. It bends only at reflex
  /// vertices of the region and may run along its boundary, but not through a point in which free space is connected by
  /// that point alone (a and b may be such points). nullopt if an end is outside, the two are not connected, or the
  /// length exceeds `longest`. Deterministic; may be called by several threads.
  std::optional<Polyline> path(const Point& a, const Point& b,
                               double longest = std::numeric_limits<double>::infinity()) const;
  /// The same. No path from a point p to b is shorter than to_end(p), metres: the better this bound, the less of the
  /// region is searched.
  std::optional<Polyline> path(const Point& a, const Point& b, double longest,
                               const std::function<double(const Point&)>& to_end) const;
  /// Calls visit(path) for every taut (locally shortest) path from a to b not longer than `longest`, that is one for
  /// each homotopy class, by increasing length, until `visit` returns false. Paths whose prefix from a to a bend
  /// `admits` (if given) rejects are pruned. Returns false if the search ended because of `budget`, the number of cones
  /// that it may continue through a triangle: then there may be more paths. There can be exponentially many classes;
  /// each costs about as much as one path.
  bool for_each_taut_path(const Point& a, const Point& b, double longest, std::size_t budget,
                          const std::function<bool(const Polyline&)>& visit,
                          const std::function<bool(const Polyline&)>& admits = {}) const;
  const Mesh& mesh() const;

  struct Impl;

 private:
  std::shared_ptr<const Impl> impl_;
};

}  // namespace oxturn
