// Euclidean shortest paths inside a region, among holes.
//
// Source      Cui, Harabor, Grastien, "Compromise-free Pathfinding on a Navigation Mesh" (Polyanya), IJCAI 2017
// Optimal: A* over intervals of triangle edges; only what the answer needs is expanded, nothing is prepared but
// the triangulation. Typical cost grows with the triangles between the ends, not with the region. In a part without holes
// there is but one sleeve of triangles between two places: its funnel is taken at once (dual_tree.hpp).
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "geometry/mesh/mesh.hpp"

namespace oxturn {

class ShortestPaths {
 public:
  /// `tolerance`: ends that lie outside the region by no more than this are taken as at the nearest place of its
  /// boundary.
  ShortestPaths(const Region& region, double tolerance);
  /// The same for a region that is meshed already.
  ShortestPaths(Mesh mesh, double tolerance);
  ~ShortestPaths();
  ShortestPaths(ShortestPaths&&) noexcept;

  /// From a to b, both included, bending only at reflex corners of the region: no way is shorter but for the rounding of
  /// lengths. It may run along walls, but not through a place where free space hangs together in a point only (an end
  /// may lie there). nullopt if an end is outside, the two are not connected, or the length exceeds `longest`.
  /// Deterministic; safe to call from several threads.
  std::optional<Polyline> path(const Point& a, const Point& b,
                               double longest = std::numeric_limits<double>::infinity()) const;
  /// Every taut (locally shortest) path from a to b no longer than `longest`, which is one for each homotopy class, by
  /// increasing length, until `visit` says false. Whatever begins like a path from a to a bend that `admits` (if given)
  /// turns down is left out. False if `budget` expansions of a cone by a triangle did not do: there may be more.
  /// Classes can be exponentially many; each costs about as much as one path.
  bool for_each_taut_path(const Point& a, const Point& b, double longest, std::size_t budget,
                          const std::function<bool(const Polyline&)>& visit,
                          const std::function<bool(const Polyline&)>& admits = {}) const;
  const Mesh& mesh() const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace oxturn
