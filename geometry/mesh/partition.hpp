/// Partitions of a region into simpler parts.
///
///   for (const BoustrophedonCell& cell : boustrophedon_cells(free)) plan_lanes(cell);
///   for (const Ring& part : convex_partition_approximate(free)) fill(part);
#pragma once

#include "geometry/region.hpp"

namespace oxturn {

/// The least number of convex parts with vertices of the region (Greene 1983, by CGAL). A polygon with holes or
/// repeated vertices is first divided by a few diagonals into simple pieces, and the parts are the fewest for each
/// piece: for the whole the problem is NP-hard. About cubic. Throws std::invalid_argument above `most_vertices`, and
/// std::runtime_error where CGAL 5.5 returns something that is not a convex partition, which happens with collinear
/// vertices.
std::vector<Ring> convex_partition_optimal(const Region& region, std::size_t most_vertices = 150);
/// At most four times the least number of convex parts: triangulates, then removes every diagonal that convexity does
/// not need (Hertel and Mehlhorn 1983). O(n log n).
std::vector<Ring> convex_partition_approximate(const Region& region);
/// y-monotone parts with vertices of the region: triangulates, then removes every diagonal that is not needed at a
/// vertex with both neighbours above or both below (Lee and Preparata 1977). At most one part more than there are such
/// vertices and polygons together. CGAL's y_monotone_partition_2 is no substitute: its parts overlap where edges are
/// horizontal. O(n log n).
std::vector<Ring> monotone_partition(const Region& region);
/// Trapezoids between vertical lines through every vertex, each ending at the first wall (Latombe 1991). O(n log n).
std::vector<Ring> trapezoid_partition(const Region& region);

/// A cell of the boustrophedon decomposition (Choset and Pignon 1997) for a plane sweep along +x: every vertical line
/// meets it in one interval, from its chain `lower` to its chain `upper`, both left to right.
struct BoustrophedonCell {
  Polyline lower, upper;
  std::vector<std::size_t> neighbours;  // cells that share part of a critical line, ascending
};
/// Divides the region only at critical points, where the sweep line extends into free space both upwards and downwards.
/// Events are ordered by x, then y, with exact predicates; divisions that only vertical walls would cause are undone.
/// Chains do not begin or end with a vertical edge, but may contain some. A rectangle with k convex holes in general
/// position has 3 k + 1 cells. O(n log n). Throws std::invalid_argument where edges cross or overlap; repaired()
/// removes overlaps.
std::vector<BoustrophedonCell> boustrophedon_cells(const Region& region);
/// The parts of trapezoid_partition() with their neighbours. Parts narrower than `least` metres (along x) are joined
/// with those beside them, unless a critical point is between: with `least` infinite they are the boustrophedon cells.
/// O(n log n); throws as above.
std::vector<BoustrophedonCell> trapezoid_cells(const Region& region, double least = 0);

}  // namespace oxturn
