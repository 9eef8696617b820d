// Runs a planner that drives a CellRobot: on the true map, or by lidar. What online grid planners share.
#pragma once

#include <functional>
#include <string>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lattice/cell_robot.hpp"

namespace oxturn {

struct CellSettings {
  double cell_size = 0;        // metres; 0: tool width / sqrt 2, so that a disc tool on the centre lines covers cells
  std::string align = "axes";  // edges: turned to the direction most walls run in; needs sensing = map
  std::string sensing =
      "map";                   // map: cells are felt on the true map (the papers' model); lidar: as the robot sees them
  int reach = 1;               // how far the robot feels, in cells
  bool straight_paths = false;  // the walk asks for ways off the lattice
  bool follows_walls = false;  // the walk uses a WallFollower; needs sensing = map
};
inline constexpr const char* kAlignHelp = "edges: turn the grid to the direction most walls run in (sensing = map)";
inline constexpr const char* kSensingHelp =
    "map: the cells about the robot are felt on the map; lidar: seen by its lidar";

/// The lattice hangs on the start; `walk` drives the robot from there and returns when it is done.
/// Throws Infeasible if there is no cell beside the start's, Unsupported for sensing = lidar without one.
Path walk_cells(const Problem& problem, Context& context, const CellSettings& settings,
                const std::function<void(CellRobot&)>& walk);

}  // namespace oxturn
