/// Refuses maps that no path could cover in any time worth waiting for, before the planner begins.
///
///   planners.add(size_limited_planner(my_planner()));
///
/// More than 10^8 squares as wide as the tool in the space where the robot works make the planner throw Infeasible with
/// the remedy: mostly the map's scale is wrong, or the tool's width. Drawings are left to their planner, whose effort
/// grows with the strokes and not with the canvas. Planners with the parameter `cell_size` stay as they are: they
/// count their cells, which may be larger than the tool (lattice/grid_graph.hpp).
#pragma once

#include "algorithms/coverage_planner.hpp"

namespace oxturn {

PlannerInfo size_limited_planner(PlannerInfo info);

}  // namespace oxturn
