// A dent: consecutive edges of a ring, bent at each corner towards the side on which an offset of the ring lies.
// What their strips (edge x reach) cover together, written down without an overlay. Private to geometry: not installed.
//
// Method      T: what lies behind none of the edges' lines, and neither before the first edge's start nor past the last
//             edge's end (seen along those edges). The dent is {x in T: within `reach` of one of the lines}: a polygon of
//             the edges, the two ends' perpendiculars, and in between either the edges' lines shifted by `reach`, as far
//             as they bound what lies beyond all of them, or nothing, where the perpendiculars cross before.
// Certain     Nothing of the dent is farther than `reach` from an edge: take its nearest line; the foot there is a
//             point of the edge, for T excludes the rest of the line (another line or an end is in the way).
//             Nothing is forgotten: let x be within `reach` of the ring's inside, y its nearest point, on an edge i of
//             the dent. The edges turn by less than a quarter, so x is behind no line. If x lay before the first edge's
//             start p, the way from x to y would cross p's perpendicular at a z that is no farther from y than from
//             p, while edge i + 1 is no nearer to z. `clear` shows for every edge that there is no such z, or the
//             dent ends earlier. The other end likewise.
//             Rounding: the corners at the far side move by a quantum, which leaves cracks where the neighbouring
//             edge's strip does not cover them: `overlaps` asks for some quanta more than that.
// Complexity  k edges: O(k^2) for the longest dent from a given edge, k at most kLongestConcaveChain.
#pragma once

#include <vector>

#include "geometry/overlay/arrangement.hpp"

namespace oxturn {

/// A ring with its directions, seen from the side on which the offset lies.
struct Walk {
  Walk(const std::vector<Site>& sites, double side);  // side: +1 left, -1 right; at least two sites
  std::size_t before(std::size_t i) const { return i == 0 ? ring.size() - 1 : i - 1; }
  Point inwards(std::size_t edge) const { return side * perpendicular(along[edge]); }

  const std::vector<Site>& ring;
  double side;
  std::vector<Point> along;          // edge i: from corner i to the next
  std::vector<double> length, bend;  // sine of the bend at corner i; positive: inwards, the strips overlap
};

struct ConcaveChain {
  std::size_t begin, end;  // edges, end > begin
  std::vector<Point> far;  // the dent's other side, from corner `begin` to corner `end`, in lattice units
};

/// The ring, or line, without corners that lie within a quantum of the way between those that are left: rounding put
/// them there and made bends of straight walls.
std::vector<Site> straightened(const std::vector<Site>& corners, bool ring);

/// The longest dent found from edge `begin` on, before edge `limit`. The corners begin .. limit all bend inwards. One
/// edge's dent is its strip.
ConcaveChain longest_concave_chain(const Walk& walk, std::size_t begin, std::size_t limit, double reach);

}  // namespace oxturn
