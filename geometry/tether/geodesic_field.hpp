// Geodesic distances from one point (a tether's anchor), among polygon obstacles and barriers: the shortest-path map.
//
// Source      Mitchell, "Shortest paths among obstacles in the plane", 1996 (continuous Dijkstra over cones of sight,
//             here on a triangulation); windows are filtered as in Xin & Wang 2009 (improved Chen-Han)
// Model       d(x) = min over settled corners c that see x of d(c) + |c - x|. Every corner keeps the cone that it is
//             the last bend for; each triangle keeps the few cones that may be shortest somewhere in it.
// Complexity  about O(n log n) for n corners on real maps; a question O(cones of one triangle)
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "geometry/mesh/mesh.hpp"
#include "geometry/point.hpp"
#include "geometry/region.hpp"

namespace oxturn {

/// Segments across gaps of free space that a disc of diameter `width` cannot pass: for every two obstacles (rings;
/// the outer one counts as one) that a chain of such gaps joins, shortest gaps first, as many as it takes to join
/// them (a minimum spanning forest over gaps < width). Their ends lie on the boundary: at a corner, or inside an edge.
/// So closed, free space has the homotopy of where the disc's centre may be. O(n log n) for usual data.
std::vector<Polyline> barriers(const Region& free, double width);

class GeodesicField {
 public:
  /// `tolerance`: how far outside free space a point of a question may lie. Throws std::invalid_argument if the anchor
  /// is farther outside than that.
  GeodesicField(const Region& free, const Point& anchor, const std::vector<Polyline>& barriers, double tolerance);
  ~GeodesicField();
  GeodesicField(GeodesicField&&) noexcept;

  const Point& anchor() const;
  /// Length of the shortest way to p; infinity if there is none (other part of free space, or outside).
  double distance(const Point& p) const;
  /// anchor, corners, p: the shortest way. Empty if there is none.
  Polyline path(const Point& p) const;
  /// The corner (or anchor) from which the shortest way comes straight, and the way's length up to there.
  struct Sight {
    Point from{0, 0};
    double before = std::numeric_limits<double>::infinity();
    std::size_t corners = 0;  // on the way, `from` included unless it is the anchor
  };
  Sight sight(const Point& p) const;
  /// The largest distance within free space that can be reached, metres.
  double farthest() const;

  /// Circular arc about a corner (or the anchor), counter-clockwise from angle `begin` to `end` (radians, begin < end).
  struct Arc {
    Point centre{0, 0};
    double radius = 0;
    double begin = 0, end = 0;
    Point at(double angle) const { return centre + radius * Point(std::cos(angle), std::sin(angle)); }
  };
  /// The places at distance `l`, as chains of arcs, each chain one piece of the boundary of {distance < l}. Arcs follow
  /// one another counter-clockwise; a chain goes on from a corner's arc to that of the next corner (where the shorter
  /// way to both runs along one ray), and ends at walls, at barriers, and where two different ways round an obstacle
  /// meet. A closed chain ends where it begins. Chains are in the order of their place round the anchor, by the first
  /// corner where their ways part. O(triangles + arcs) a question.
  std::vector<std::vector<Arc>> level_set(double l) const;

  /// The cut locus: where two or more shortest ways, different ones round an obstacle, meet. Pieces of hyperbolas as
  /// polylines with at most `chord` metres of error. They join each hole of free space (with barriers) to another or to
  /// the border, and meet each other in shared points; ends lie on walls (within 1e-6 of the map's extent). One
  /// polyline lies in one triangle; they are not joined into longer ones.
  std::vector<Polyline> cut_locus(double chord) const;

  const Mesh& mesh() const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

/// Points along the chain, chord error at most `chord`, arcs' ends exact.
Polyline sampled(const std::vector<GeodesicField::Arc>& chain, double chord);

}  // namespace oxturn
