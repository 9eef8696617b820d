/// The area within a given distance of a concave chain, as one polygon, without an overlay. Private to geometry, not
/// installed.
///
/// A concave chain is a sequence of edges of a ring, bent at every inner vertex towards the side on which an offset of
/// the ring lies, such as an arc that an earlier offset in the other direction left. Each edge's strip (edge x reach)
/// overlaps most of the others, and uniting n strips by an overlay means n^2 crossings.
///
///            far side
///         ,-----------.         Strips of five edges; the polygon is what they cover together:
///        /             \        the edges themselves, the perpendiculars at the two ends, and
///       |\             /|       on the far side the envelope of the shifted lines. Where the
///       | \           / |       perpendiculars cross before the envelope begins, the far side
///       |  `\_______/'  |       is the one point in which they cross.
///
/// Method      Let T be the set of points that are behind no line of an edge, nor before the first edge's start, nor
///             past the last edge's end (measured along those two edges). The polygon is P = {x in T: x is within
///             `reach` of at least one line}.
/// Sound       No point x of P is farther than `reach` from the chain. Take the line nearest to x: the foot of x on it
///             is a point of its edge, because T excludes all points whose foot lies on the rest of the line (another
///             line or an end of the chain comes before).
/// Complete    P contains every x for which the ring's nearest point y is on the chain and within `reach`. The chain
///             turns by less than a quarter in all, so x is behind no line. Suppose that x is before the start p of the
///             first edge. Then the segment xy crosses the perpendicular at p in a point z whose nearest point is y as
///             well: if y is on edge i, neither p nor edge i + 1 is nearer to z. clear_before() proves for each i that
///             no such z exists; otherwise the chain is ended earlier. The same holds at the other end.
/// Rounding    Vertices on the far side move by up to a quantum. That may open gaps along the end perpendiculars, but
///             the neighbouring edges' strips overlap them by several quanta: overlaps_neighbours() makes sure.
/// Complexity  O(k^2) for the longest chain of k edges from a given edge; k is at most kLongestConcaveChain.
#pragma once

#include "geometry/overlay/lattice.hpp"

namespace oxturn {

/// A ring with its directions, seen from the side on which the offset lies.
struct Walk {
  /// At least two points; side: +1 left of the ring, -1 right.
  Walk(const std::vector<LatticePoint>& points, double side);
  std::size_t before(std::size_t i) const { return i == 0 ? ring.size() - 1 : i - 1; }
  /// The unit normal of an edge towards the offset.
  Point normal(std::size_t edge) const { return side * perpendicular(along[edge]); }

  const std::vector<LatticePoint>& ring;
  double side;
  std::vector<Point> along;          // by edge, from vertex i to the next: unit direction
  std::vector<double> length, bend;  // of edge i; sine of the bend at vertex i, positive towards the offset
};

struct ConcaveChain {
  std::size_t begin, end;  // its edges: begin .. end - 1
  std::vector<Point> far;  // the polygon's far side, from above vertex `begin` to above vertex `end`, in quanta
};

/// The points of a ring or open line without vertices that lie within a quantum of the segments between those that are
/// left: rounding to the lattice put them there, and bends into straight walls.
std::vector<LatticePoint> straightened_ring(const std::vector<LatticePoint>& ring);
std::vector<LatticePoint> straightened_line(const std::vector<LatticePoint>& line);

/// The longest concave chain found that begins with edge `begin` and ends before edge `limit`. All vertices from
/// `begin` to `limit` must bend towards the offset. The chain of one edge is its strip. `reach` is in quanta.
ConcaveChain longest_concave_chain(const Walk& walk, std::size_t begin, std::size_t limit, double reach);

}  // namespace oxturn
