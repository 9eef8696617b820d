#include "algorithms/grid/cell_planner.hpp"

#include <cmath>

namespace oxturn {

double cell_side_of(double given, const Robot& robot) { return given > 0 ? given : robot.tool_width / std::sqrt(2.0); }

Path walk_cells(const Problem& problem, Context& context, double side, const std::string& sensing, int reach,
                const std::function<void(CellRobot&)>& walk) {
  (void)context;
  if (sensing == "lidar") throw Unsupported("sensing = lidar is not yet there");
  const GridGraph graph = grid_about_start(problem, side);
  CellRobot robot = robot_at_start(problem, graph, reach);
  walk(robot);
  return robot.take();
}

}  // namespace oxturn
