/// The straight skeleton of a polygon: the traces of its vertices while all edges move inwards at unit speed.
///
///   const StraightSkeleton skeleton = straight_skeleton(polygon);
///   for (const StraightSkeleton::Arc& a : skeleton.arcs)
///     skeleton.nodes[a.low].time;                        // metres that the edges have moved where the arc begins
///
/// By CGAL (Aichholzer and Aurenhammer 1996; Felkel and Obdrzalek 1998), with exact predicates and rounded
/// constructions, but reflex vertices are tested against edges near by only (split_candidates.hpp). O(n log n) for n
/// vertices of usual polygons; O(n^2) with reflex vertices so sharp that they cross the whole polygon.
#pragma once

#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

struct StraightSkeleton {
  struct Node {
    Point at;
    double time = 0;  // 0: a vertex of the polygon
  };
  /// A vertex moving between two events, on the border of two faces.
  struct Arc {
    std::size_t low, high;  // nodes; the lower one is not later
    std::size_t faces[2];
  };
  std::vector<Node> nodes = {};
  std::vector<Arc> arcs = {};
  std::vector<Point> directions = {};  // of each face's edge, unit length; free space to the left
};

/// Holes are part of it. Throws std::runtime_error if CGAL fails.
StraightSkeleton straight_skeleton(const Polygon& polygon);

}  // namespace oxturn
