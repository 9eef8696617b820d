// Exact planar overlay on an integer lattice: what booleans, offsets and repair stand on. Private to geometry: not
// installed.
//
// Method      Closed rings become weighted edges on the lattice. Edges are split where they meet, intersections
//             rounded to the lattice, and split again until no two meet but at common ends (iterated snap rounding:
//             an edge also bends to any lattice point it passes within half a quantum, so slivers thinner than
//             that close up). Winding numbers then follow by walking round the vertices; edges between inside
//             and outside are kept.
// Source      Halperin, Packer: Iterated snap rounding, 2002; winding numbers: McMains, Chen: Polygon offsetting
//             by computing winding numbers, 2005.
// Why not Clipper 6: its union is quadratic in the number of edges that a scan line meets (10^4 capsules: 2 s),
//             and rounded results may cross themselves. Here every sign is an integer sign, and results are valid.
// Complexity  O((n + k) log n) for n edges meeting k times, usual data; nearly O(n + k) where edges are short and spread
//             evenly over the map: sorting (spread_sort.hpp), the search for meetings (close_pairs.hpp) and for what lies
//             below a component (edge_below.hpp) are then linear. Pieces that met everything in one round are not sorted
//             again, and only cells with a new piece are searched.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

/// A lattice point; |x|, |y| <= 2^29, so that products of differences fit 64 bits.
struct Site {
  std::int32_t x = 0, y = 0;
  friend bool operator==(const Site&, const Site&) = default;
  friend auto operator<=>(const Site&, const Site&) = default;
};

/// Doubles <-> lattice. The quantum is a power of two and the origin a multiple of it: what was snapped once to this
/// or a coarser lattice is not moved again.
class Lattice {
 public:
  explicit Lattice(const Box& box);
  Site snap(const Point& p) const;
  Point place(const Site& s) const;
  double quantum() const { return quantum_; }

 private:
  double quantum_ = 1, x_ = 0, y_ = 0;  // origin in quanta
};

/// a < b; crossing it from its right to its left adds `first` and `second` to the two operands' winding numbers.
struct OverlayEdge {
  Site a, b;
  std::int32_t first = 0, second = 0;
};
/// An edge of a result: inside on the left.
struct BoundaryEdge {
  Site from, to;
};

using Inside = bool (*)(int first, int second);

/// The ring on the lattice, points that fall together once.
std::vector<Site> snapped(const Ring& ring, const Lattice& lattice);
/// Adds the closed ring with the given weights (1: counts as it runs, -1: as if reversed).
void add_ring(std::vector<OverlayEdge>& edges, const std::vector<Site>& ring, int first, int second);
/// Adds a region, outer rings counted counter-clockwise and holes clockwise, however they run.
void add_region(std::vector<OverlayEdge>& edges, const Region& region, const Lattice& lattice, int first, int second);
/// The rim of the set of points whose winding numbers satisfy `inside`.
std::vector<BoundaryEdge> rim(std::vector<OverlayEdge> edges, Inside inside);
/// Rims as operands of another overlay.
void add_boundary(std::vector<OverlayEdge>& edges, const std::vector<BoundaryEdge>& rim, int first, int second);
/// A rim's rings, nested, exactly collinear corners dropped; rings touch in points at most. Canonical order. The rim's
/// edges come in the order in which rim() gives them.
Region to_region(const std::vector<BoundaryEdge>& rim, const Lattice& lattice);

/// Straight corners dropped, the least corner first.
Ring canonical_ring(const std::vector<Site>& sites, const Lattice& lattice);
/// Sorts holes and polygons by their corners.
void put_in_order(Region& region);

/// Throws std::invalid_argument unless all coordinates are finite.
Box finite_box(const Region& region);

}  // namespace oxturn
