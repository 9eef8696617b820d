// Offline spanning tree coverage that takes in partly occupied coarse cells (sub_cell_tree.hpp).
#pragma once

#include <string>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lattice/grid_graph.hpp"

namespace oxturn {

/// Round every connected part of the free sub-cells, nearest first; `all` = false: the first one only. `tree` as for
/// `stc`. Columns and rows of `fine` are even. O(n) for n sub-cells. Throws Infeasible if no sub-cell is free.
Path go_round_partial(const Problem& problem, const GridGraph& fine, const std::string& tree, bool all,
                      Context& context);

}  // namespace oxturn
