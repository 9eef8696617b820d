/// Exact overlay of rings on an integer lattice, on which booleans, offsets and repair are built. Private to geometry,
/// not installed.
///
///   std::vector<OverlayEdge> edges;
///   add_region(edges, a, lattice, {1, 0});
///   add_region(edges, b, lattice, {0, 1});
///   return to_region(boundary_of(std::move(edges), inside_both), lattice);
///
/// Method      Closed rings become weighted edges on the lattice. Edges are split where they meet, at points rounded to
///             the lattice, and split again until any two meet at common ends only (resolve.hpp): iterated snap
///             rounding. An edge also bends to every lattice point that it passes within half a quantum, so slivers
///             thinner than that collapse. Winding numbers then follow by walking around the vertices; the result's
///             boundary is the edges between inside and outside.
/// Source      Halperin and Packer, "Iterated snap rounding", 2002; winding numbers: McMains and Chen, "Polygon
///             offsetting by computing winding numbers", 2005.
/// Complexity  O((n + k) log n) for n edges that meet k times, usual data; nearly O(n + k) where edges are short and
///             spread evenly, because sorting (sorting.hpp), the search for meeting edges (close_pairs.hpp) and
///             point location (edge_below.hpp) are then linear. Edges that met nothing in one round are not sorted
///             again, and only what lies near new ones is searched.
#pragma once

#include <array>
#include <cstdint>

#include "geometry/overlay/lattice.hpp"

namespace oxturn {

/// Winding numbers with respect to the first and second operand, or an edge's contribution to them.
struct Windings {
  std::int32_t first = 0, second = 0;
  friend bool operator==(const Windings&, const Windings&) = default;
  friend Windings operator+(Windings v, Windings w) { return {v.first + w.first, v.second + w.second}; }
  friend Windings operator-(Windings v, Windings w) { return {v.first - w.first, v.second - w.second}; }
};

/// a < b. Crossing the edge from its right to its left adds `weight` to the winding numbers.
struct OverlayEdge {
  LatticePoint a, b;
  Windings weight;
};
/// An edge of a result, with the inside on its left.
struct BoundaryEdge {
  LatticePoint from, to;
};

/// Adds a closed ring with a weight, as it runs: its left gets `weight`.
void add_ring(std::vector<OverlayEdge>& edges, const std::vector<LatticePoint>& ring, Windings weight);
/// Adds a region. Outer rings count as counter-clockwise and holes as clockwise, whatever their orientation.
void add_region(std::vector<OverlayEdge>& edges, const Region& region, const Lattice& lattice, Windings weight);
/// Adds the result of one overlay as an operand of another.
void add_boundary(std::vector<OverlayEdge>& edges, const std::vector<BoundaryEdge>& boundary, Windings weight);

using Inside = bool (*)(Windings);
inline bool inside_first(Windings w) { return w.first > 0; }
inline bool inside_first_only(Windings w) { return w.first > 0 && w.second <= 0; }
inline bool inside_both(Windings w) { return w.first > 0 && w.second > 0; }
/// The boundary of the set of points whose winding numbers satisfy `inside`, in the order of the edges' lower ends.
std::vector<BoundaryEdge> boundary_of(std::vector<OverlayEdge> edges, Inside inside);
/// Two such boundaries from one arrangement.
std::array<std::vector<BoundaryEdge>, 2> boundaries_of(std::vector<OverlayEdge> edges, std::array<Inside, 2> inside);

/// Quanta by which offset curves are moved to the safe side. It covers the roundings of a curve (0.7 quanta for each
/// vertex, shifted point and intersection, half a quantum where an edge bends) in up to five unions of halves and the
/// final overlay; where rings and chains are straightened, by a quantum each, there are at most four unions.
inline constexpr double kOffsetSlack = 10;

/// The boundary as a canonical region: rings nested into polygons, exactly collinear vertices left out, rings touch
/// each other in points at most and never themselves. The edges must be in the order of boundary_of().
Region to_region(const std::vector<BoundaryEdge>& boundary, const Lattice& lattice);
/// The ring in metres without collinear vertices, its lowest vertex (by x, then y) first.
Ring canonical_ring(const std::vector<LatticePoint>& ring, const Lattice& lattice);
/// Sorts holes and polygons by their vertices.
void put_in_order(Region& region);

}  // namespace oxturn
