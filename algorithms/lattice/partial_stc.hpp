/// Offline spanning tree coverage that also enters partly occupied coarse cells (sub_cell_tree.hpp).
///
///   if (p_.partial) return cover_partial_cells(problem, p_.lattice(problem, 2), p_, context);
///
/// Guarantee   every free sub-cell (with Components::start: that free lattice edges connect to the first) is visited,
///             each component on a closed path of at most (n + m) D for its n sub-cells of side D, m of which share a
///             point with a blocked one
/// O(n log n) for n sub-cells.
#pragma once

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lattice/spanning_trees.hpp"

namespace oxturn {

/// Drives around the tree of every connected component of the free sub-cells, each from where the path passes nearest
/// to it (component_links.hpp); with Components::start around the first one only. Columns and rows of `fine` are even.
/// Throws Infeasible if no sub-cell is free.
Path cover_partial_cells(const Problem& problem, const GridGraph& fine, const TreeOptions& options, Context& context);

}  // namespace oxturn
