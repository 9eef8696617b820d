/// MyCarbot (TH Nuernberg) in a known world: partitions it, drives from rectangle to rectangle and cleans each lane by
/// lane.
///
///   Path path = clean_rectangles(options, problem, graph, std::vector<bool>(graph.size(), false), context).path;
///
/// Costs: see rectangles.cpp.
#pragma once

#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/grid/rectangle_options.hpp"
#include "algorithms/lattice/lattice_paths.hpp"

namespace oxturn {

struct CleanedRectangles {
  Path path;                        // empty if no rectangle can be driven
  std::size_t rectangles = 0;       // driven
  std::size_t skipped_columns = 0;  // or rows, where the robot does not fit
  std::size_t skipped_cells = 0;    // in these and before shifted starts
  std::size_t small_cells = 0;      // in rectangles that are too small to be driven
};
/// `graph`: the lattice over the problem's configuration space. `done`: nodes that have been cleaned before.
CleanedRectangles clean_rectangles(const RectangleOptions& options, const Problem& problem, const GridGraph& graph,
                                   std::vector<bool> done, Context& context);

}  // namespace oxturn
