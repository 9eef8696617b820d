// Spanning tree coverage for a tethered robot: round the shortest-path tree of coarse cells.
//
// Source      after Peng et al. 2025 (spanning tree coverage for tethered robots); Gabriely and Rimon 2001
// Model       grid of coarse cells 2D x 2D, offline, disc footprint
// Guarantee   visits each sub-cell of the tree's cells exactly once, closed, length n D for n sub-cells; the tether is
//             the geodesic throughout, at most depth * 2D + sqrt 2 * D in a coarse cell of that depth (plus the start's
//             length, if the anchor is elsewhere), and never driven over.
//             partial = true: visits every sub-cell whose centre is free, in every component of the cut space
//             (tether_space.hpp), each set of connected sub-cells on a closed path of at most (n + m) D, m of them
//             sharing a point with a blocked one (proof: sub_cell_tree.hpp), and drives to other sets and back. All of
//             that lies in the cut space, so the tether is the geodesic again. With reach = depth only the sub-cells
//             within k steps of the start, k D + the start's length <= L: a path of k steps leads to each of them in
//             the cut space, so the geodesic is no longer than k D more than the start's.
// Complexity  O(lattice nodes); partial = true: O(n log n)
// Decisions   1. The tree grows in the space cut open along the anchor's cut locus (tether_space.hpp). Round a tree in
//                the uncut space the tether lies in the tree's class, which behind an obstacle may be the longer one.
//             2. The robot starts at a sub-cell's centre. Of the four positions of that sub-cell in its coarse cell the
//                one with the most cells is taken.
//             3. `reach = depth`: cells with depth * 2D + sqrt 2 * D above the tether length are omitted. Depth is
//                measured along the lattice, so in the open the cells form a diamond. `reach = geodesic` (ours) keeps
//                all: the tether is the geodesic, and configuration space ends at the tether's reach.
//             4. `partial = true` (ours, after Gabriely and Rimon 2003): of the four positions of the start the one
//                with the shortest path is taken; the sub-cells are the same.
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "algorithms/lattice/cell_robot.hpp"
#include "algorithms/lattice/coarse_cells.hpp"
#include "algorithms/lattice/partial_stc.hpp"
#include "algorithms/lattice/promised_cells.hpp"
#include "algorithms/tethered/cell_parameters.hpp"
#include "algorithms/transit/tether_space.hpp"

namespace oxturn {
namespace {

constexpr std::array<std::array<int, 2>, 4> kShifts{{{0, 0}, {1, 0}, {0, 1}, {1, 1}}};  // of the start's coarse cell

struct Params : TreeParameters {
  bool partial = false;
};

struct Tour {
  std::size_t cells = 0;  // coarse cells of the tree
  Polyline points;        // closed, from the start
  std::vector<Polyline> tree;
  std::vector<Cell> sub_cells;
  std::optional<GridGraph> fine;
};

GridGraph fine_cells(const Problem& problem, double side, const std::array<int, 2>& shift) {
  return make_grid_graph_at(problem.configuration_space(), problem.map().name,
                            problem.start() - side * Point(shift[0], shift[1]), side);
}

std::size_t deepest_cell(TreeReach reach, const TetherSpace& space, double side) {
  if (reach == TreeReach::geodesic) return std::numeric_limits<std::size_t>::max();
  const double remaining =
      space.tether_length() - space.field().distance(space.problem().start()) - std::sqrt(2.0) * side;
  if (remaining < 0)
    throw Infeasible("the tether is too short to go round one coarse cell; a smaller cell_size may help");
  return static_cast<std::size_t>(remaining / (2 * side) + 1e-9);
}

/// With the start's sub-cell at (0, 0) + shift in its coarse cell; nullopt if the tree has at most `than` cells.
std::optional<Tour> larger_tour(std::size_t than, const TetherSpace& space, double side,
                                const std::array<int, 2>& shift, std::size_t deepest) {
  const Point& start = space.problem().start();
  GridGraph fine = fine_cells(space.cut_problem(), side, shift);
  CoarseCells cells(fine);
  const Cell first = fine.cell_of(start);
  const std::size_t root = cells.at(first.i / 2, first.j / 2);
  if (!cells.free(root)) return std::nullopt;
  const std::vector<std::size_t> reached = grow_breadth_first(cells, root, deepest);
  if (reached.size() <= than) return std::nullopt;
  Tour tour{reached.size(), round_tree(fine, cells, first), tree_lines(cells), {}, {}};
  tour.points.front() = tour.points.back() = start;  // exactly, not rounded
  for (const std::size_t c : reached)
    for (const auto& [i, j] : kShifts) tour.sub_cells.push_back({2 * cells.column(c) + i, 2 * cells.row(c) + j});
  tour.fine = std::move(fine);
  return tour;
}

Path drive_round_whole_cells(const Params& p, const TetherSpace& space, Context& context) {
  const double side = p.side(space.problem().robot());
  const std::size_t deepest = deepest_cell(p.reach, space, side);
  Tour best;
  for (const auto& shift : kShifts)
    if (auto tour = larger_tour(best.cells, space, side, shift, deepest)) best = std::move(*tour);
  if (best.cells == 0)
    throw Infeasible("no coarse cell of twice the cell size fits at the start; a smaller cell_size may help");
  promise_cells(context, *best.fine, std::move(best.sub_cells), space.problem().robot().tool_width);
  if (context.wants_traces()) context.trace("tree", std::move(best.tree));
  PathBuilder path(space.problem().start());
  path.drive(best.points, true);
  return path.take();
}

/// Leaves the sub-cells that at most so many steps over the lattice lead to.
void remove_distant(GridGraph& fine, const Cell& first, std::size_t most_steps) {
  std::vector<std::size_t> steps(fine.size(), fine.size());
  steps[fine.at(first)] = 0;
  std::vector<Cell> queue{first};
  breadth_first(queue, [&](const Cell& at, const auto& reach) {
    for (const Direction d : kAllDirections) {
      const Cell to = neighbour(at, d);
      if (steps[fine.at(at)] == most_steps || !fine.passable(at, d) || steps[fine.at(to)] < fine.size()) continue;
      steps[fine.at(to)] = steps[fine.at(at)] + 1;
      reach(to);
    }
  });
  for (std::size_t node = 0; node < fine.size(); ++node)
    if (steps[node] == fine.size()) fine.remove(fine.cell(node));
}

/// Round the partly occupied cells of one component, too.
Path cover_component(const Params& p, const TetherSpace& space, const TetherSpace::Component& component,
                     Context& context) {
  const Problem& problem = component.problem;
  const double side = p.side(problem.robot());
  const bool by_depth = p.reach == TreeReach::depth;
  const double remaining = space.tether_length() - space.field().distance(problem.start());
  TreeOptions options;
  options.components = by_depth ? Components::start : Components::all;
  Path best;
  for (const auto& shift : kShifts) {
    GridGraph fine = fine_cells(problem, side, shift);
    const std::optional<Entry> entry = entry_from_start(problem, fine);
    if (!entry) throw Infeasible("no sub-cell is free; a smaller cell_size may help");
    const double steps = (remaining - length(entry->path)) / side + 1e-9;
    if (by_depth && steps < 1) throw Infeasible("the tether is too short for one step; a smaller cell_size may help");
    if (by_depth) remove_distant(fine, entry->cell, static_cast<std::size_t>(steps));
    Context inner(1, context.seconds_left(), {});
    Path path = cover_partial_cells(problem, fine, options, inner);
    if (path.legs.empty()) throw Infeasible("no sub-cell beside the start's is free; a smaller cell_size may help");
    if (!best.legs.empty() && (path.length() >= best.length() || context.cancelled())) continue;
    best = std::move(path);
    if (component.index == 0)
      promise_free_cells(context, fine, options.components, entry->cell, problem.robot().tool_width);
  }
  return best;
}

Path plan(const Params& p, const Problem& problem, Context& context) {
  const TetherSpace space(problem, "tethered-stc");
  if (context.wants_traces()) context.trace("cut", space.cut());
  if (!p.partial) return drive_round_whole_cells(p, space, context);
  return cover_components(
      space, [&](const auto& component, Context&) { return cover_component(p, space, component, context); }, true,
      context);
}

}  // namespace

PlannerInfo tethered_stc() {
  return describe<Params, plan>(
      {.name = "tethered-stc",
       .family = "tethered",
       .title = "spanning tree coverage round the shortest-path tree",
       .citation = "after Peng et al. 2025",
       .capabilities = {Capability::tether, Capability::holes},
       .guarantee = "each sub-cell of the tree's cells exactly once, closed; tether the geodesic, never driven over",
       .promise = Promise::cells,
       .symmetries = {Symmetry::shift, Symmetry::quarter_turn, Symmetry::mirror, Symmetry::scale},
       .parameters = with_tree_parameters<Params>(
           {{"partial", &Params::partial, "also enter coarse cells of which only some sub-cells are free"}})});
}

}  // namespace oxturn
