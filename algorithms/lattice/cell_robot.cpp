#include "algorithms/lattice/cell_robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/transit/nearest_component.hpp"

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

CellRobot::Lattice CellRobot::lattice() const {
  if (!graph_) throw std::logic_error("only on the true map is a robot's lattice known");
  return {*graph_, i0_, j0_};
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

namespace {
// Where no wall is near, one look at all of them is cheaper than an index, which may be larger than the lattice.
bool surely_free(const Region& space, const Point& a, const Point& b) {
  const Point low = a.cwiseMin(b), high = a.cwiseMax(b);
  bool free = true;
  for_each_ring(space, [&](const Ring& ring) {
    for (std::size_t k = 0, last = ring.size() - 1; k < ring.size(); last = k++) {
      const Point &p = ring[last], &q = ring[k];
      free = free && (std::max(p.x(), q.x()) < low.x() || std::min(p.x(), q.x()) > high.x() ||
                      std::max(p.y(), q.y()) < low.y() || std::min(p.y(), q.y()) > high.y());
    }
  });
  return free;
}
}  // namespace

std::optional<Entry> entry_from_start(const Problem& problem, const GridGraph& graph) {
  const Point at = graph.coordinates(problem.start());
  const int i = static_cast<int>(std::lround(at.x())), j = static_cast<int>(std::lround(at.y()));
  const Point centre = graph.centre(i, j);
  if (graph.free(i, j) && (surely_free(problem.configuration_space(), problem.start(), centre) ||
                           problem.walls().contains(problem.start(), centre)))
    return Entry{i, j, {problem.start(), centre}};
  NearestComponent nearest(problem);
  for (int row = 0; row < graph.rows(); ++row)
    for (int column = 0; column < graph.columns(); ++column)
      if (graph.free(column, row)) nearest.add(graph.centre(column, row), 0, graph.at(column, row));
  auto found = nearest.from(problem.start());
  if (!found) return std::nullopt;
  const auto columns = static_cast<std::size_t>(graph.columns());
  return Entry{static_cast<int>(found->id % columns), static_cast<int>(found->id / columns), std::move(found->path)};
}

}  // namespace oxturn
