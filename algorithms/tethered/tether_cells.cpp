#include "algorithms/tethered/tether_cells.hpp"

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lattice/wall_crossings.hpp"
#include "geometry/edge_index.hpp"

namespace oxturn {
namespace {

std::optional<Point> nearest_on(const std::vector<Polyline>& lines, const Point& p) {
  std::optional<Point> best;
  for (const Polyline& line : lines)
    for (std::size_t k = 1; k < line.size(); ++k) {
      const Point candidate = nearest_on_segment(p, line[k - 1], line[k]);
      if (!best || distance(candidate, p) < distance(*best, p)) best = candidate;
    }
  return best;
}

}  // namespace

TetherCells::TetherCells(const Problem& problem, const Region& space, double side, CellKind kind)
    : lattice_(make_grid_graph_at(space, problem.map().name, problem.start(), side)),
      walls_(kind == CellKind::partial ? walls_in_cells(lattice_, space) : Walls(1)) {
  const std::size_t start = lattice_.at(lattice_.cell_of(problem.start()));
  const ConnectedComponents parts = components_of(lattice_);
  const auto joined = [&](std::size_t node) {
    return node == start || (parts.of[node] >= 0 && parts.of[node] == parts.of[start]);
  };
  const EdgeIndex walls(space);
  std::vector<std::size_t> index(lattice_.size(), kNone);  // cell at each node
  for (std::size_t node = 0; node < lattice_.size(); ++node) {
    const auto at = node == start ? std::optional(problem.start())
                                  : position_in(node, kind, joined(node), walls);  // start: exactly
    if (!at) continue;
    if (node == start) root_ = cells_.size();
    index[node] = cells_.size();
    nodes_.push_back(node);
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
      const Cell at = lattice_.cell(nodes_[c]), beside = oxturn::neighbour(at, d);
      const std::size_t n = lattice_.inside(beside.i, beside.j) ? index[lattice_.at(beside)] : kNone;
      if (n == kNone) continue;
      const bool on_lattice = joined(nodes_[c]) && joined(nodes_[n]);
      if (!(on_lattice ? lattice_.passable(at, d) : connected(cells_[c].at, cells_[n].at))) continue;
      neighbours_[c][d] = n;
      neighbours_[n][opposite(d)] = c;
    }
}

std::optional<Point> TetherCells::position_in(std::size_t node, CellKind kind, bool joined,
                                              const EdgeIndex& walls) const {
  const Point centre = lattice_.centre(node);
  if (joined) return centre;
  if (kind == CellKind::joined) return std::nullopt;
  if (walls.contains(centre)) return centre;
  if (kind == CellKind::partial) return nearest_on(walls_[node], centre);
  const auto wall = walls.nearest(centre, side());
  if (!wall || (wall->point - centre).cwiseAbs().maxCoeff() > side() / 2) return std::nullopt;
  return wall->point;
}

std::vector<Cell> TetherCells::central(const CellList& list) const {
  std::vector<Cell> central;
  for (const std::size_t c : list)
    if (c == root_ || cells_[c].at == lattice_.centre(nodes_[c])) central.push_back(lattice_.cell(nodes_[c]));
  return central;
}

}  // namespace oxturn
