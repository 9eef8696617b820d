#include "algorithms/tethered/tether_cells.hpp"

#include <cmath>

#include "algorithms/coverage_planner.hpp"
#include "base/graph_search.hpp"
#include "geometry/edge_index.hpp"

namespace oxturn {
namespace {

struct Node {
  int i, j;
  bool operator==(const Node&) const = default;
};

Node nearest_node(const GridGraph& graph, const Point& p) {
  const Point at = graph.coordinates(p);
  return {static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))};
}

/// For each node whether free edges connect it to `from`.
std::vector<bool> joined_to(const GridGraph& graph, const Node& from) {
  std::vector<bool> joined(graph.size(), false);
  joined[graph.at(from.i, from.j)] = true;
  std::vector<Node> queue{from};
  breadth_first(queue, [&](const Node& at, auto reach) {
    for (const Direction d : kAllDirections) {
      if (!graph.passable(at.i, at.j, d)) continue;
      const Node next{at.i + kColumnStep[d], at.j + kRowStep[d]};
      if (joined[graph.at(next.i, next.j)]) continue;
      joined[graph.at(next.i, next.j)] = true;
      reach(next);
    }
  });
  return joined;
}

}  // namespace

TetherCells::TetherCells(const Problem& problem, const Region& space, double side, CellKind kind) : side_(side) {
  const GridGraph graph = make_grid_graph_at(space, problem.map().name, problem.start(), side);
  const Node start = nearest_node(graph, problem.start());
  const std::vector<bool> joined = joined_to(graph, start);
  const EdgeIndex walls(space);
  const auto position_in = [&](int i, int j) -> std::optional<Point> {
    if (Node{i, j} == start) return problem.start();  // exactly, not rounded
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
      if (const auto at = position_in(i, j)) {
        index[graph.at(i, j)] = cells_.size();
        if (Node{i, j} == start) root_ = cells_.size();
        cells_.push_back({i, j, *at, problem.tether()->geodesics().distance(*at)});
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
      const int i = cells_[c].column, j = cells_[c].row, i2 = i + kColumnStep[d], j2 = j + kRowStep[d];
      const std::size_t n = graph.inside(i2, j2) ? index[graph.at(i2, j2)] : kNone;
      if (n == kNone) continue;
      const bool on_lattice = joined[graph.at(i, j)] && joined[graph.at(i2, j2)];
      if (!(on_lattice ? graph.passable(i, j, d) : connected(cells_[c].at, cells_[n].at))) continue;
      neighbours_[c][d] = n;
      neighbours_[n][opposite(d)] = c;
    }
}

}  // namespace oxturn
