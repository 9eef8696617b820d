#include "algorithms/grid/cell_planner.hpp"

#include <stdexcept>

#include "algorithms/lattice/promised_cells.hpp"
#include "algorithms/online/driver.hpp"

namespace oxturn {
namespace {

/// The lattice's edges; a straight run of them is one line.
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

/// A lattice as the lidar shows it, with a node at the start and along the axes. A step between cells is passable where
/// the robot is believed to fit along it. What is unknown counts as wall, and may open when more has been seen.
class LidarCells final : public CellWorld {
 public:
  // The radius less the problem's tolerance: rounding must not close a passage as wide as the robot.
  LidarCells(OnlineRobot& robot, double side)
      : robot_(robot),
        side_(side),
        radius_(std::max(0.0, robot.view().robot.radius - 1e-6 * robot.view().robot.tool_width)) {}
  bool straight(const Cell& from, const Cell& to) override {
    return robot_.view().belief.free_for(centre(from), centre(to), radius_);
  }
  bool go_straight(const Cell& from, const Cell& to, bool tool) override {
    if (robot_.go({{centre(to)}, tool})) return true;
    // Stopped on the way by what it saw. What lies behind was free when the robot came, so it goes back.
    robot_.go({{centre(from)}, tool});
    return false;
  }
  Point centre(const Cell& c) const override { return robot_.view().start + side_ * Point(c.i, c.j); }

 private:
  OnlineRobot& robot_;
  double side_, radius_;
};

Path drive_by_lidar(const Problem& problem, Context& context, const CellOptions& options, const CellNeeds& needs,
                    const std::function<void(CellRobot&)>& drive) {
  if (problem.limited())
    throw Unsupported("sensing = lidar shows walls only, but this problem's space ends elsewhere; use sensing = map");
  const double side = options.side(problem.robot());
  const auto program = [&](OnlineRobot& robot, Context&) {
    LidarCells cells(robot, side);
    CellRobot on_cells(cells, side, needs.reach);
    drive(on_cells);
  };
  return drive_online(problem, program, context);
}

}  // namespace

Path drive_cells(const Problem& problem, Context& context, const CellOptions& options, const CellNeeds& needs,
                 const std::function<void(CellRobot&)>& drive) {
  if (options.sensing == Sensing::lidar) return drive_by_lidar(problem, context, options, needs, drive);
  GridGraph graph =
      grid_at_start(problem, options.side(problem.robot()), lattice_angle(options.align, problem.map().free));
  if (needs.diagonals) graph.add_diagonals(problem.configuration_space());
  CellRobot robot = robot_at_start(problem, graph, needs.reach);
  if (needs.all_cells)
    promise_free_cells(context, graph, Components::start, graph.cell_of(problem.start()), problem.robot().tool_width);
  if (context.wants_traces()) context.trace("lattice", lattice_lines(graph));
  drive(robot);
  return robot.take();
}

Path walk_cells(const Problem& problem, Context& context, const CellOptions& options, const CellNeeds& needs,
                const std::function<void(CellWalk&)>& walk) {
  return drive_cells(problem, context, options, needs, [&](CellRobot& robot) {
    CellWalk cells(robot, context);
    walk(cells);
    cells.record_figures();
  });
}

}  // namespace oxturn
