/// Geodesic distances from one point, a tether's anchor, among polygonal obstacles and barriers: the shortest-path map.
///
///   const GeodesicField field(free_space, anchor, barriers(free_space, 2 * radius), tolerance);
///   field.distance(p);                          // infinity: not reachable
///   for (const auto& chain : field.level_set(10.0)) drive(sampled(chain, chord_error));
///
/// Source      Mitchell, "Shortest paths among obstacles in the plane", 1996 (continuous Dijkstra over cones of sight,
///             here on a triangulation); windows are pruned as in Xin and Wang 2009 (improved Chen-Han)
/// Model       d(x) is the least of d(c) + |x - c| over all settled corners c that see x. Every corner keeps the cone
///             for which it is the last bend; each triangle keeps the few cones that may be shortest somewhere in it.
/// Complexity  about O(n log n) for n vertices on real maps; a query costs the cones of one triangle
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "base/math.hpp"
#include "geometry/mesh/mesh.hpp"

namespace oxturn {

/// Segments that close gaps of free space narrower than `width`, which a disc of that diameter cannot pass. For every
/// two obstacles (rings; the outer one counts as one) that a chain of such gaps connects, as many as it takes to
/// connect them, shortest gaps first: a minimum spanning forest. Their ends lie on the boundary, at a vertex or inside
/// an edge. Closed in this way, free space has the homotopy classes of the disc's configuration space. If `anchor` lies
/// in such a gap, or where one begins, the barrier across that gap passes through it. O(n log n) for usual data.
std::vector<Polyline> barriers(const Region& free, double width, const std::optional<Point>& anchor = {});

class GeodesicCones;

class GeodesicField {
 public:
  /// Points of queries, and the anchor, may be outside free space by at most `tolerance`. Throws std::invalid_argument
  /// if the anchor is farther outside. Where barriers or touching rings divide free space at the anchor, paths leave it
  /// on one side only: that of the shortest path to `start`. No start: on all sides.
  GeodesicField(const Region& free, const Point& anchor, const std::vector<Polyline>& barriers, double tolerance,
                const std::optional<Point>& start = {});

  const Point& anchor() const { return anchor_; }
  /// Length of the shortest path to p, metres; infinity if there is none.
  double distance(const Point& p) const;
  /// The shortest path: anchor, corners, p. Empty if there is none.
  Polyline path(const Point& p) const;
  /// The last segment of the shortest path to a point.
  struct Sight {
    Point from{0, 0};                                         // the last corner, or the anchor
    double before = std::numeric_limits<double>::infinity();  // length of the path up to there
    std::size_t corners = 0;                                  // on the path
  };
  Sight sight(const Point& p) const;
  /// The largest distance of any point that can be reached, metres.
  double farthest() const;

  /// A circular arc about a corner (or the anchor), counter-clockwise between two angles, radians.
  struct Arc {
    Point centre{0, 0};
    double radius = 0;
    double begin = 0, end = 0;  // begin < end
    Point at(double angle) const { return centre + radius * Point(math::cos(angle), math::sin(angle)); }
  };
  /// The points at distance `length`, as chains of arcs; each chain is one piece of the boundary of {distance <
  /// length}. Its arcs follow one another counter-clockwise. A chain continues from the arc about one corner to that
  /// about the next where the shortest paths to both run along one ray, and ends at walls, at barriers, and where two
  /// different paths around an obstacle meet. A closed chain ends where it begins. Chains are ordered around the
  /// anchor, by the first corner at which their paths part. O(triangles + arcs).
  std::vector<std::vector<Arc>> level_set(double length) const { return std::move(level_sets({length}).front()); }
  /// The same for many lengths, ascending. O(triangles + arcs) in all; as many level_set() would each look at all
  /// triangles.
  std::vector<std::vector<std::vector<Arc>>> level_sets(const std::vector<double>& lengths) const;

  /// The cut locus: the points to which there are two or more shortest paths, different ones around an obstacle. Pieces
  /// of hyperbolas as polylines, with an error of at most `chord_error` metres; one polyline lies in one triangle. They
  /// connect each hole of free space (with barriers) to another or to the outer boundary, and meet in common points;
  /// ends on walls are accurate to 1e-6 of the map's extent. Throws std::invalid_argument unless the error is positive.
  /// `beyond`: only pieces with a point that is farther from the anchor than so many metres.
  std::vector<Polyline> cut_locus(double chord_error, double beyond = 0) const;
  /// Computes now what the first call of cut_locus() without `beyond` would, and keeps it.
  void find_cut_locus() const;

 private:
  Point anchor_;
  std::shared_ptr<const GeodesicCones> cones_;
};

/// Points along a chain with an error of at most `chord_error` metres; ends of arcs are exact.
Polyline sampled(const std::vector<GeodesicField::Arc>& chain, double chord_error);

}  // namespace oxturn
