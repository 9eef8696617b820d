#include "algorithms/grid/cell_planner.hpp"

#include <cmath>
#include <stdexcept>

#include "algorithms/online/lidar_cells.hpp"

namespace oxturn {

Path walk_cells(const Problem& problem, Context& context, const CellSettings& settings,
                const std::function<void(CellRobot&)>& walk) {
  const double side = settings.cell_size > 0 ? settings.cell_size : problem.robot().tool_width / std::sqrt(2.0);
  const bool edges = settings.align == "edges";
  if (settings.sensing == "lidar") {
    if (edges) throw std::invalid_argument("align = edges needs the map; sensing = lidar goes with align = axes");
    return drive_online(
        problem,
        [&](OnlineRobot& robot, Context&) {
          LidarCells cells(robot, side);
          CellRobot on_cells(cells, side, settings.reach);
          walk(on_cells);
        },
        context);
  }
  GridGraph graph = grid_about_start(problem, side, edges ? dominant_direction(problem.map().free) : 0);
  if (settings.straight_ways) graph.look_between(problem.configuration_space());
  CellRobot robot = robot_at_start(problem, graph, settings.reach);
  walk(robot);
  return robot.take();
}

}  // namespace oxturn
