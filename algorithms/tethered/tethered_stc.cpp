// Spanning tree coverage for a tethered robot: round the shortest-path tree of coarse cells.
//
// Source      after Peng et al. 2025 (spanning tree coverage for tethered robots); Gabriely and Rimon 2001
// Model       grid of coarse cells 2D x 2D, offline, disc footprint
// Guarantee   visits each sub-cell of the tree's cells exactly once, closed, length n D for n sub-cells; the tether is
//             the geodesic throughout, at most depth * 2D + sqrt 2 * D in a coarse cell of that depth (plus the start's
//             length, if the anchor is elsewhere), and never driven over
// Complexity  O(lattice nodes)
// Decisions   1. The tree grows in the space cut open along the anchor's cut locus (tether_space.hpp). Round a tree in
//                the uncut space the tether lies in the tree's class, which behind an obstacle may be the longer one.
//             2. The robot starts at a sub-cell's centre. Of the four positions of that sub-cell in its coarse cell the
//                one with the most cells is taken.
//             3. `reach = depth`: cells with depth * 2D + sqrt 2 * D above the tether length are omitted. Depth is
//                measured along the lattice, so in the open the cells form a diamond. `reach = geodesic` (ours) keeps
//                all: the tether is the geodesic, and configuration space ends at the tether's reach.
#include <cmath>
#include <limits>
#include <optional>

#include "algorithms/lattice/coarse_cells.hpp"
#include "algorithms/tethered/cell_parameters.hpp"
#include "algorithms/transit/tether_space.hpp"

namespace oxturn {
namespace {

struct Tour {
  std::size_t cells = 0;  // coarse cells of the tree
  Polyline points;        // closed, from the start
  std::vector<Polyline> tree;
};

std::size_t deepest_cell(TreeReach reach, const TetherSpace& space, double side) {
  if (reach == TreeReach::geodesic) return std::numeric_limits<std::size_t>::max();
  const double remaining =
      space.tether_length() - space.field().distance(space.problem().start()) - std::sqrt(2.0) * side;
  if (remaining < 0)
    throw Infeasible("the tether is too short to go round one coarse cell; a smaller cell_size may help");
  return static_cast<std::size_t>(remaining / (2 * side) + 1e-9);
}

/// With the start's sub-cell at (0, 0) + shift in its coarse cell; nullopt if the tree has at most `than` cells.
std::optional<Tour> larger_tour(std::size_t than, const TetherSpace& space, double side, const Point& shift,
                                std::size_t deepest) {
  const Point& start = space.problem().start();
  const GridGraph fine = make_grid_graph_at(space.cut_space(), space.problem().map().name, start - side * shift, side);
  CoarseCells cells(fine);
  const Cell first = fine.cell_of(start);
  const std::size_t root = cells.at(first.i / 2, first.j / 2);
  if (!cells.free(root)) return std::nullopt;
  const std::size_t count = grow_breadth_first(cells, root, deepest).size();
  if (count <= than) return std::nullopt;
  Tour tour{count, round_tree(fine, cells, first), tree_lines(cells)};
  tour.points.front() = tour.points.back() = start;  // exactly, not rounded
  return tour;
}

Path plan(const TreeParameters& p, const Problem& problem, Context& context) {
  const TetherSpace space(problem, "tethered-stc");
  const double side = p.side(problem.robot());
  const std::size_t deepest = deepest_cell(p.reach, space, side);
  Tour best;
  for (const Point& shift : {Point(0, 0), Point(1, 0), Point(0, 1), Point(1, 1)})
    if (auto tour = larger_tour(best.cells, space, side, shift, deepest)) best = std::move(*tour);
  if (best.cells == 0)
    throw Infeasible("no coarse cell of twice the cell size fits at the start; a smaller cell_size may help");
  if (context.wants_traces()) {
    context.trace("cut", space.cut());
    context.trace("tree", std::move(best.tree));
  }
  PathBuilder path(problem.start());
  path.drive(best.points, true);
  return path.take();
}

}  // namespace

PlannerInfo tethered_stc() {
  return describe<TreeParameters, plan>(
      {.name = "tethered-stc",
       .family = "tethered",
       .title = "spanning tree coverage round the shortest-path tree",
       .citation = "after Peng et al. 2025",
       .capabilities = {Capability::tether, Capability::holes},
       .guarantee = "each sub-cell of the tree's cells exactly once, closed; tether the geodesic, never driven over",
       .parameters = with_tree_parameters<TreeParameters>({})});
}

}  // namespace oxturn
