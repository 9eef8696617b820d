#include "algorithms/tethered/tether_cells.hpp"

#include <cmath>
#include <utility>

#include "algorithms/coverage_planner.hpp"
#include "geometry/edge_index.hpp"

namespace oxturn {
namespace {

/// The nodes that free edges join to (i0, j0).
std::vector<bool> joined_to(const GridGraph& graph, int i0, int j0) {
  std::vector<bool> joined(graph.size(), false);
  std::vector<std::pair<int, int>> queue{{i0, j0}};
  joined[graph.at(i0, j0)] = true;
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const auto [i, j] = queue[k];
    for (const Direction d : kAllDirections) {
      if (!graph.passable(i, j, d)) continue;
      const int i2 = i + kColumnStep[d], j2 = j + kRowStep[d];
      if (joined[graph.at(i2, j2)]) continue;
      joined[graph.at(i2, j2)] = true;
      queue.push_back({i2, j2});
    }
  }
  return joined;
}

}  // namespace

TetherCells::TetherCells(const Problem& problem, const Region& space, double side, CellKind kind) : side_(side) {
  const GridGraph graph = make_grid_graph_at(space, problem.map().name, problem.start(), side);
  const Point at = graph.coordinates(problem.start());
  const int i0 = static_cast<int>(std::lround(at.x())), j0 = static_cast<int>(std::lround(at.y()));
  const std::vector<bool> joined = joined_to(graph, i0, j0);
  const EdgeIndex walls(space);
  const auto place_in = [&](int i, int j) -> std::optional<Point> {
    if (i == i0 && j == j0) return problem.start();  // itself, not a rounded copy of it
    const Point centre = graph.centre(i, j);
    if (joined[graph.at(i, j)]) return centre;
    if (kind == CellKind::joined) return std::nullopt;
    if (walls.contains(centre)) return centre;
    const auto wall = walls.nearest(centre, side);
    if (!wall || (wall->point - centre).cwiseAbs().maxCoeff() > side / 2) return std::nullopt;
    return wall->point;
  };

  std::vector<std::size_t> index(graph.size(), kNone);
  for (int j = 0; j < graph.rows(); ++j)
    for (int i = 0; i < graph.columns(); ++i)
      if (const auto place = place_in(i, j)) {
        index[graph.at(i, j)] = cells_.size();
        if (i == i0 && j == j0) root_ = cells_.size();
        cells_.push_back({i, j, *place, problem.tether()->geodesics().distance(*place)});
      }
  if (cells_.size() == 1)
    throw Infeasible("no cell beside the start's own can be driven to; a smaller cell_size may help");

  // Places at a rounded corner do not see each other, but are next to each other.
  const auto reached = [&](const Point& a, const Point& b) {
    return walls.contains(a, b) || problem.transit().path(a, b, 2 * side).has_value();
  };
  neighbours_.assign(cells_.size(), {kNone, kNone, kNone, kNone});
  for (std::size_t c = 0; c < cells_.size(); ++c)
    for (const Direction d : {kEast, kNorth}) {
      const int i = cells_[c].column, j = cells_[c].row, i2 = i + kColumnStep[d], j2 = j + kRowStep[d];
      const std::size_t n = graph.inside(i2, j2) ? index[graph.at(i2, j2)] : kNone;
      if (n == kNone) continue;
      const bool lattice = joined[graph.at(i, j)] && joined[graph.at(i2, j2)];
      if (!(lattice ? graph.passable(i, j, d) : reached(cells_[c].place, cells_[n].place))) continue;
      neighbours_[c][d] = n;
      neighbours_[n][opposite(d)] = c;
    }
}

}  // namespace oxturn
