#include "algorithms/lattice/cell_robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/transit/nearest_component.hpp"

namespace oxturn {
namespace {

/// True if no wall's bounding box meets that of ab. Cheaper than the index of walls, which may be larger than the
/// lattice, if it has not been built yet.
bool far_from_walls(const Region& space, const Point& a, const Point& b) {
  const Point low = a.cwiseMin(b), high = a.cwiseMax(b);
  bool far = true;
  for_each_ring(space, [&](const Ring& ring) {
    for (std::size_t k = 0, last = ring.size() - 1; k < ring.size(); last = k++) {
      const Point &p = ring[last], &q = ring[k];
      far = far && (std::max(p.x(), q.x()) < low.x() || std::min(p.x(), q.x()) > high.x() ||
                    std::max(p.y(), q.y()) < low.y() || std::min(p.y(), q.y()) > high.y());
    }
  });
  return far;
}

}  // namespace

void CellRobot::throw_out_of_reach(const Cell& c) const {
  throw std::logic_error(fmt::format("a robot in cell ({}, {}) that feels {} cells far was asked about cell ({}, {})",
                                     at_.i, at_.j, reach_, c.i, c.j));
}

void CellRobot::drive(const Polyline& points, const Cell& end, bool tool) {
  if (!graph_) throw std::logic_error("a robot can leave the lattice on the true map only");
  end_run();
  path_.drive(points, tool);
  at_ = end;
  ++steps_;
}

bool CellRobot::go_straight(const Cell& to) {
  if (!graph_) return world_->go_straight(at_, to, false) && (at_ = to, ++steps_, true);
  if (!straight(at_, to)) return false;
  drive({centre(to)}, to, false);
  return true;
}

CellRobot::Lattice CellRobot::lattice() const {
  if (!graph_) throw std::logic_error("a robot's lattice is known on the true map only");
  return {*graph_, first_};
}

Path CellRobot::take() {
  if (graph_) end_run();
  return path_.take();
}

GridGraph grid_at_start(const Problem& problem, double side, double angle) {
  return make_grid_graph_at(problem.configuration_space(), problem.map().name, problem.start(), side, angle);
}

CellRobot robot_at_start(const Problem& problem, const GridGraph& graph, int reach) {
  const Cell at = graph.cell_of(problem.start());
  if (std::none_of(kAllDirections.begin(), kAllDirections.end(), [&](Direction d) { return graph.passable(at, d); }))
    throw Infeasible("no neighbour of the start's cell can be reached; a smaller cell_size may help");
  return CellRobot(graph, at, PathBuilder(problem.start()), reach);
}

std::optional<Entry> entry_from_start(const Problem& problem, const GridGraph& graph) {
  const Cell at = graph.cell_of(problem.start());
  const Point centre = graph.centre(at);
  if (graph.free(at) && (far_from_walls(problem.configuration_space(), problem.start(), centre) ||
                         problem.walls().contains(problem.start(), centre)))
    return Entry{at, {problem.start(), centre}};
  NearestComponent nearest(problem);
  for (std::size_t node = 0; node < graph.size(); ++node)
    if (graph.free(graph.cell(node))) nearest.add(graph.centre(node), 0, node);
  auto found = nearest.from(problem.start());
  if (!found) return std::nullopt;
  return Entry{graph.cell(found->id), std::move(found->path)};
}

}  // namespace oxturn
