// Euclidean shortest paths inside a region, among holes.
//
// Source      Cui, Harabor, Grastien, "Compromise-free Pathfinding on a Navigation Mesh" (Polyanya), IJCAI 2017
// Optimal: A* over intervals of triangle edges; only what the answer needs is expanded, nothing is prepared but
// the triangulation. Typical cost grows with the triangles between the ends, not with the region.
#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "geometry/mesh.hpp"

namespace oxturn {

class ShortestPaths {
 public:
  /// `tolerance`: ends that lie outside the region by no more than this are taken as on its boundary.
  ShortestPaths(const Region& region, double tolerance);
  ~ShortestPaths();
  ShortestPaths(ShortestPaths&&) noexcept;

  /// From a to b, both included, bending only at reflex corners of the region. nullopt if an end is outside, the
  /// two are not connected, or the length exceeds `longest`. Deterministic; safe to call from several threads.
  std::optional<Polyline> path(const Point& a, const Point& b,
                               double longest = std::numeric_limits<double>::infinity()) const;
  const Mesh& mesh() const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

}  // namespace oxturn
