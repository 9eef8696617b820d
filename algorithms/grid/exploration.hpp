/// A planner that explores cells from a wall on and returns to its start: what cell-explore and smart-dfs share.
///
///   class Explorer { public: explicit Explorer(CellWalk& walk); void run(Direction heading); };
///   PlannerInfo cell_explore() { return describe_exploration<Explorer>("cell-explore", "...", "Icking et al. 2005"); }
///
/// A start away from walls: the robot first drives straight south to one, from where the exploration begins. Moves over
/// visited cells are driven with the tool off.
#pragma once

#include <string>

#include "algorithms/grid/cell_planner.hpp"

namespace oxturn {

template <class Explorer>
Path explore_cells(const CellOptions& options, const Problem& problem, Context& context) {
  return walk_cells(problem, context, options, {}, [](CellWalk& walk) {
    const Cell home = walk.at();
    const Direction heading = walk.heading_from_wall();
    Explorer(walk).run(heading);
    walk.go_to_cell(home);
  });
}

template <class Explorer>
PlannerInfo describe_exploration(std::string name, std::string title, std::string citation) {
  return describe<CellOptions, explore_cells<Explorer>>(
      {.name = std::move(name),
       .family = "grid",
       .title = std::move(title),
       .citation = std::move(citation),
       .capabilities = {Capability::holes, Capability::online},
       .guarantee = "visits every free cell that free lattice edges connect to the start, and returns to the start",
       .promise = Promise::cells,
       .symmetries = {Symmetry::shift, Symmetry::scale},
       .parameters = with_cell_options<CellOptions>({})});
}

}  // namespace oxturn
