/// Online spanning tree coverage: what stc-spiral and stc-scan share. The tree grows while the robot drives around it.
///
///   PlannerInfo stc_spiral() {
///     return describe_online_stc<ChildOrder::counter_clockwise>("stc-spiral", "...", "Gabriely & Rimon 2001");
///   }
///
/// O(1) a step; 2 bytes a sub-cell.
#pragma once

#include <string>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lattice/grid_options.hpp"

namespace oxturn {

struct OnlineStcOptions : CellOptions {
  bool partial = false;
};
/// In which order a cell's children in the tree are visited, from its parent on.
enum class ChildOrder {
  counter_clockwise,
  vertical_first  // counter-clockwise, but children east and west are left to vertical neighbours where possible
};

/// Throws Infeasible if no coarse cell at the start is free (unless options.partial), or if the robot cannot step
/// anywhere.
template <ChildOrder order>
Path cover_by_growing_tree(const OnlineStcOptions& options, const Problem& problem, Context& context);

template <ChildOrder order>
PlannerInfo describe_online_stc(std::string name, std::string title, std::string citation) {
  return describe<OnlineStcOptions, cover_by_growing_tree<order>>(
      {.name = std::move(name),
       .family = "grid",
       .title = std::move(title),
       .citation = std::move(citation),
       .capabilities = {Capability::holes, Capability::online},
       .guarantee = "each sub-cell of the free coarse cells connected to the start exactly once, on a closed path",
       .promise = Promise::cells,
       .symmetries = {Symmetry::shift, Symmetry::scale},
       .parameters = with_cell_options<OnlineStcOptions>(
           {{"partial", &OnlineStcOptions::partial,
             "also enter coarse cells of which only some sub-cells are free (2002)"}})});
}

}  // namespace oxturn
