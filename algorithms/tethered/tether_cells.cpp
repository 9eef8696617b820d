#include "algorithms/tethered/tether_cells.hpp"

#include "algorithms/coverage_planner.hpp"
#include "geometry/edge_index.hpp"

namespace oxturn {

TetherCells::TetherCells(const Problem& problem, const Region& space, double side, CellKind kind) : side_(side) {
  const GridGraph graph = make_grid_graph_at(space, problem.map().name, problem.start(), side);
  const std::size_t start = graph.at(graph.cell_of(problem.start()));
  const ConnectedComponents parts = components_of(graph);
  const auto joined = [&](std::size_t node) {
    return node == start || (parts.of[node] >= 0 && parts.of[node] == parts.of[start]);
  };
  const EdgeIndex walls(space);
  const auto position_in = [&](std::size_t node) -> std::optional<Point> {
    if (node == start) return problem.start();  // exactly, not rounded
    const Point centre = graph.centre(node);
    if (joined(node)) return centre;
    if (kind == CellKind::joined) return std::nullopt;
    if (walls.contains(centre)) return centre;
    const auto wall = walls.nearest(centre, side);
    if (!wall || (wall->point - centre).cwiseAbs().maxCoeff() > side / 2) return std::nullopt;
    return wall->point;
  };

  std::vector<std::size_t> index(graph.size(), kNone), nodes;  // cell at each node; node of each cell
  for (std::size_t node = 0; node < graph.size(); ++node)
    if (const auto at = position_in(node)) {
      if (node == start) root_ = cells_.size();
      index[node] = cells_.size();
      nodes.push_back(node);
      cells_.push_back({*at, problem.tether()->geodesics().distance(*at)});
    }
  if (cells_.size() == 1)
    throw Infeasible("the robot reaches no cell beside that of its start; a smaller cell_size may help");

  // Points at a rounded corner may not see each other, although they are next to each other.
  const auto connected = [&](const Point& a, const Point& b) {
    return walls.contains(a, b) || problem.transit().path(a, b, 2 * side).has_value();
  };
  neighbours_.assign(cells_.size(), {kNone, kNone, kNone, kNone});
  for (std::size_t c = 0; c < cells_.size(); ++c)
    for (const Direction d : {kEast, kNorth}) {
      const Cell at = graph.cell(nodes[c]), beside = oxturn::neighbour(at, d);
      const std::size_t n = graph.inside(beside.i, beside.j) ? index[graph.at(beside)] : kNone;
      if (n == kNone) continue;
      const bool on_lattice = joined(nodes[c]) && joined(nodes[n]);
      if (!(on_lattice ? graph.passable(at, d) : connected(cells_[c].at, cells_[n].at))) continue;
      neighbours_[c][d] = n;
      neighbours_[n][opposite(d)] = c;
    }
}

}  // namespace oxturn
