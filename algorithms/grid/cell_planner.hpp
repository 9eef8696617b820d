// Runs a planner that drives a CellRobot: on the true map, or by lidar. What online grid planners share.
#pragma once

#include <functional>
#include <string>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/grid/cell_robot.hpp"

namespace oxturn {

/// Side of a cell: `given`, or by default tool width / sqrt 2, so that a disc tool on the centre lines covers cells.
double cell_side_of(double given, const Robot& robot);

/// The lattice hangs on the start; `walk` drives the robot from there and returns when it is done.
/// `sensing`: "map", the cells up to `reach` about the robot are felt on the true map (the papers' model); "lidar", they
/// are what its lidar has shown to be free. Throws Infeasible if there is no cell beside the start's, Unsupported for
/// "lidar" without one.
Path walk_cells(const Problem& problem, Context& context, double side, const std::string& sensing, int reach,
                const std::function<void(CellRobot&)>& walk);

}  // namespace oxturn
