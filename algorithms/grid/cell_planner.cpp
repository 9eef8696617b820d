#include "algorithms/grid/cell_planner.hpp"

#include <cmath>
#include <stdexcept>

#include "algorithms/online/lidar_cells.hpp"

namespace oxturn {

namespace {

// The ways between cells, a line for each straight run of them.
std::vector<Polyline> lattice_lines(const GridGraph& graph) {
  std::vector<Polyline> lines;
  for (const Direction d : {kEast, kNorth})
    for (int j = 0; j < graph.rows(); ++j)
      for (int i = 0; i < graph.columns(); ++i) {
        if (!graph.passable(i, j, d) || graph.passable(i, j, opposite(d))) continue;
        int i2 = i, j2 = j;
        for (; graph.passable(i2, j2, d); i2 += kColumnStep[d], j2 += kRowStep[d]) {}
        lines.push_back({graph.centre(i, j), graph.centre(i2, j2)});
      }
  return lines;
}

}  // namespace

Path walk_cells(const Problem& problem, Context& context, const CellSettings& settings,
                const std::function<void(CellRobot&)>& walk) {
  const double side = cell_side(settings.cell_size, problem.robot());
  const bool edges = settings.align == "edges";
  if (settings.sensing == "lidar") {
    if (edges) throw std::invalid_argument("align = edges needs the map; sensing = lidar goes with align = axes");
    if (settings.follows_walls)
      throw std::invalid_argument("partial = true needs the map; sensing = lidar goes with partial = false");
    if (problem.limited())
      throw Unsupported(
          "sensing = lidar knows of walls only, but this problem's space ends elsewhere; use sensing = map");
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
  if (settings.straight_paths) graph.look_between(problem.configuration_space());
  CellRobot robot = robot_at_start(problem, graph, settings.reach);
  if (context.wants_traces()) context.trace("lattice", lattice_lines(graph));
  walk(robot);
  return robot.take();
}

}  // namespace oxturn
