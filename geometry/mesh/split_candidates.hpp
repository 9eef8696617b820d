/// Which edges can a reflex vertex run into while a polygon shrinks? Private to geometry, not installed.
///
///   const SplitCandidates candidates(edges);             // ring by ring, the interior to the left
///   candidates.find(e0, e1, at, time, found);            // for a vertex between the fronts of two edges
///
/// All edges move inwards at unit speed. A point is swept no later than its distance to the boundary, so a vertex ends
/// before its time exceeds its distance from the nearest edge. The front of an edge reaches a point at time t along a
/// path down the roof: straight to the edge, or along valleys, at the speed of their vertices. No reflex vertex is ever
/// faster than the fastest one of the polygon, s: two that meet leave a blunter one. So the point is within s t of the
/// edge. Both bounds are kept with a tolerance; what is found is a superset, to be decided by exact predicates.
///
/// O(n) to build for n edges; a query costs the edges within s t of the vertex's path.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/uniform_grid.hpp"

namespace oxturn {

class SplitCandidates {
 public:
  struct Edge {
    Point a, b;
  };
  explicit SplitCandidates(std::vector<Edge> edges);

  /// The edges, in ascending order, that may split at the vertex between the fronts of edges e0 and e1 that is `at` at
  /// `time`, e0 and e1 among them.
  std::vector<std::uint32_t> find(std::size_t e0, std::size_t e1, const Point& at, double time) const;

 private:
  struct Motion {
    Point at;
    double time;
    Point velocity;
    Point after(double seconds) const { return at + seconds * velocity; }
  };
  Point normal(std::size_t edge) const { return perpendicular((edges_[edge].b - edges_[edge].a).normalized()); }
  double fastest_vertex() const;
  bool swept(const Point& p, double time) const;
  double longest_life(const Motion& motion) const;
  bool may_meet(const Motion& motion, double life, const Edge& edge) const;
  std::vector<std::uint32_t> all() const;

  std::vector<Edge> edges_;
  UniformGrid grid_;
  double tolerance_ = 0;  // metres
  double fastest_ = 1;    // metres of a reflex vertex, while edges move by one
};

}  // namespace oxturn
