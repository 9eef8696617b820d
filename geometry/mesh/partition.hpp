// Cutting a region into parts.
#pragma once

#include <string>
#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

/// Least number of convex parts that use the region's own corners (Greene 1983, by CGAL). A polygon with holes or
/// repeated corners is first cut by a few diagonals into simple pieces; the parts are the fewest for each piece (for
/// the whole that is NP-hard). About cubic: throws std::invalid_argument above `most_corners`, std::runtime_error where
/// CGAL 5.5 returns something that is no convex partition (it happens where corners line up).
std::vector<Ring> convex_partition_optimal(const Region& region, std::size_t most_corners = 150);
/// At most four times the least number: triangulate, then drop every diagonal that convexity does not need
/// (Hertel & Mehlhorn 1983). Holes need no bridges. O(n log n).
std::vector<Ring> convex_partition_approximate(const Region& region);
/// y-monotone parts with the region's own corners: triangulate, then drop every diagonal that no corner with both
/// neighbours above or below (Lee & Preparata 1977) needs; at most one part more than there are such corners and
/// polygons. Not by CGAL's y_monotone_partition_2, whose parts overlap where edges are level. O(n log n).
std::vector<Ring> monotone_partition(const Region& region);
/// Vertical trapezoids by the lines through every corner, stopped at the first wall (Latombe 1991).
std::vector<Ring> trapezoid_partition(const Region& region);
/// Every polygon as one weakly simple ring: holes joined to the outer ring by bridges driven twice, shortest edges of
/// the triangulation first. A polygon that touching rings cut into several open parts gives one ring for each.
/// O(n log n).
std::vector<Ring> bridged(const Region& region);

/// One cell of Choset & Pignon's boustrophedon decomposition for the sweep along +x: between `left` and `right`
/// every vertical line meets it in one interval. `lower` and `upper` are its chains, left to right.
struct BoustrophedonCell {
  Polyline lower, upper;
  std::vector<std::size_t> neighbours;  // cells that share a stretch of a critical line, ascending
};
/// Cells by critical points: only events whose sweep line extends both ways cut (OPEN, IN, OUT, CLOSE).
/// Exact predicates, equal x broken by y; cuts that vertical walls alone would cause are undone. Chains begin and end
/// with no vertical stretch, but may have some within. Throws std::invalid_argument where edges cross or overlap
/// (`repaired` mends that). O(n log n). A rectangle with k convex holes in general position has
/// 3k + 1 cells.
std::vector<BoustrophedonCell> boustrophedon_cells(const Region& region);

}  // namespace oxturn
