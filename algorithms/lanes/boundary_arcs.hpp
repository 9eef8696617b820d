/// Arcs of a region's boundary, gathered from points on it.
///
///   BoundaryArcs arcs(problem.walls());
///   for (const Point& p : uncovered) arcs.add(p);        // the boundary point nearest to p
///   for (const Ring& arc : arcs.take(tool_width)) ...    // there and back, or once around a whole ring
///
/// Points at most `join` metres apart along the boundary belong to one arc. A ring of which arcs take more than about
/// half is driven around: that is no longer. O(k log k) for k points, and the search for each of them.
#pragma once

#include <vector>

#include "geometry/edge_index.hpp"

namespace oxturn {

class BoundaryArcs {
 public:
  /// `boundary` must outlive it. O(n).
  explicit BoundaryArcs(const EdgeIndex& boundary);
  void add(const Point& p);
  /// Empties this object.
  std::vector<Ring> take(double join);

 private:
  struct Loop {
    std::size_t first, last;  // edges, `last` included
    double length;
  };
  struct Stop {
    std::size_t loop;
    double along;  // metres from the loop's first vertex
    std::size_t edge;
    Point at;
    friend bool operator<(const Stop& a, const Stop& b) {
      return a.loop != b.loop ? a.loop < b.loop : a.along < b.along;
    }
  };
  Ring arc(const Stop& from, const Stop& to) const;
  void add_arcs(const std::vector<Stop>& stops, double join, std::vector<Ring>& arcs) const;

  const EdgeIndex& boundary_;
  std::vector<Loop> loops_;
  std::vector<std::size_t> loop_of_edge_;
  std::vector<double> along_;  // of each edge's beginning
  std::vector<Stop> stops_;
};

}  // namespace oxturn
