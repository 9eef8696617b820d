#include "algorithms/grid/cell_robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/grid/nearest_part.hpp"

namespace oxturn {

void CellRobot::feels_too_far(const Cell& c) const {
  throw std::logic_error(fmt::format("a robot in cell ({}, {}) that feels {} cells far was asked about cell ({}, {})",
                                     at_.i, at_.j, reach_, c.i, c.j));
}

void CellRobot::drive(const Polyline& points, const Cell& end, bool tool) {
  if (!graph_) throw std::logic_error("only on the true map does a robot leave the lattice");
  reach_turn();
  path_.drive(points, tool);
  at_ = end;
  ++steps_;
}

bool CellRobot::go_straight(const Cell& to, bool tool) {
  if (!graph_) return world_->go_straight(at_, to, tool) && (at_ = to, ++steps_, true);
  if (!straight(at_, to)) return false;
  drive({centre(to)}, to, tool);
  return true;
}

Path CellRobot::take() {
  if (graph_) reach_turn();
  return path_.take();
}

GridGraph grid_about_start(const Problem& problem, double side, double angle) {
  return make_grid_graph_at(problem.configuration_space(), problem.map().name, problem.start(), side, angle);
}

CellRobot robot_at_start(const Problem& problem, const GridGraph& graph, int reach) {
  const Point at = graph.coordinates(problem.start());
  const int i = static_cast<int>(std::lround(at.x())), j = static_cast<int>(std::lround(at.y()));
  if (std::none_of(kAllDirections.begin(), kAllDirections.end(), [&](Direction d) { return graph.passable(i, j, d); }))
    throw Infeasible("no cell beside the start's own can be driven to; a smaller cell_size may help");
  return CellRobot(graph, i, j, PathBuilder(problem.start()), reach);
}

std::optional<Entry> entry_from_start(const Problem& problem, const GridGraph& graph) {
  const Point at = graph.coordinates(problem.start());
  const int i = static_cast<int>(std::lround(at.x())), j = static_cast<int>(std::lround(at.y()));
  if (graph.free(i, j) && problem.walls().contains(problem.start(), graph.centre(i, j)))
    return Entry{i, j, {problem.start(), graph.centre(i, j)}};
  NearestPart nearest(problem);
  for (int row = 0; row < graph.rows(); ++row)
    for (int column = 0; column < graph.columns(); ++column)
      if (graph.free(column, row)) nearest.add(graph.centre(column, row), 0, graph.at(column, row));
  auto found = nearest.from(problem.start());
  if (!found) return std::nullopt;
  const auto columns = static_cast<std::size_t>(graph.columns());
  return Entry{static_cast<int>(found->id % columns), static_cast<int>(found->id / columns), std::move(found->way)};
}

}  // namespace oxturn
