// Spanning tree coverage, offline: round a tree of coarse cells, each sub-cell once.
//
// Source      Gabriely & Rimon, "Spanning-tree based coverage of continuous areas by a mobile robot", ICRA 2001
// Model       grid of coarse cells 2D x 2D, offline, disc footprint
// Guarantee   each sub-cell (side D) of the free coarse cells connected to the first one exactly once; the round
//             is closed and its length is the number of sub-cells times D
// Complexity  n sub-cells: time and memory O(n); `weighted` and `minimum-turn` O(n log n)
//             (`components = all`: for each further part a wave to the nearest, O(n) at worst; 5 s for 260 000 cells of
//             which a tenth is blocked at random)
// Decisions   1. A coarse cell is free if the square through its four sub-cell centres, which is all that is driven
//                inside it, lies in configuration space; two are adjacent if both ways between them do.
//             2. D defaults to w / sqrt 2, so that a disc tool covers each sub-cell from its centre line; the
//                paper's square tool is cell_size = w.
//             3. The paper starts in a cell. Here the robot first drives the shortest way to the nearest sub-cell.
//             4. `components = all` (ours) goes on to the other parts of the free coarse cells, nearest first, by
//                shortest paths in configuration space; `start` is the paper.
//             5. The tree: breadth-first (counter-clockwise from east), depth-first, `minimum-turn` (depth-first
//                that goes straight on while it can), `random`, `weighted` (minimum spanning tree, vertical edges
//                dearer: long horizontal lanes).
//             6. `partial = true` (after the same authors, 2002/2003): partly occupied coarse cells are entered, too; every
//                sub-cell that free steps join to the first is visited, length <= (n + m) D (sub_cell_tree.hpp).
#include <cmath>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/grid/coarse_parts.hpp"
#include "algorithms/grid/partial_stc.hpp"

namespace oxturn {
namespace {

struct Params {
  double cell_size = 0;
  std::string tree = "bfs";
  std::string components = "all";
  std::string align = "axes";
  double shift_x = 0, shift_y = 0;
  bool partial = false;
};

class Stc final : public CoveragePlanner {
 public:
  explicit Stc(Params p) : p_(std::move(p)) {}

  Path plan(const Problem& problem, Context& context) const override {
    const double side = cell_side(p_.cell_size, problem.robot());
    const GridGraph fine = make_grid_graph(problem, {p_.cell_size, p_.align, p_.shift_x, p_.shift_y}, side, 2);
    if (p_.partial) return go_round_partial(problem, fine, p_.tree, p_.components == "all", context);
    CoarseCells cells(fine);
    const CoarseParts parts = parts_of(cells);
    if (parts.count == 0) throw Infeasible("no coarse cell of twice the cell size fits; a smaller cell_size may");

    PartsInOrder order(problem, fine, cells, parts);
    PathBuilder path(problem.start());
    for (int done = 0; done < parts.count && !context.cancelled(); ++done) {
      const std::optional<PartsInOrder::Entry> entry = order.next(path.at(), done == 0);
      if (!entry) break;
      grow_tree(cells, entry->coarse, parts, p_.tree, context.rng());
      path.drive(entry->way, false);
      path.drive(round_tree(fine, cells, entry->i, entry->j), true);
      context.progress(double(done + 1) / parts.count);
      if (p_.components == "start") break;
    }
    if (context.wants_traces()) context.trace("tree", tree_lines(cells));
    return path.take();
  }

 private:
  Params p_;
};

}  // namespace

PlannerInfo stc() {
  return describe<Stc, Params>(
      {.name = "stc",
       .family = "grid",
       .title = "spanning tree coverage, offline",
       .citation = "Gabriely & Rimon 2001",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "each sub-cell of the wholly free coarse cells exactly once, in a closed round",
       .parameters = {
           {"cell_size", &Params::cell_size, Range{0, 1000}, "side D of a sub-cell, metres; 0: tool width / sqrt 2"},
           {"tree", &Params::tree, Choices{"bfs", "dfs", "minimum-turn", "random", "weighted"}, "how the tree grows"},
           {"components", &Params::components, Choices{"all", "start"},
            "start: only the free cells connected to the first one, as published; all: then the other parts"},
           {"align", &Params::align, Choices{"axes", "edges"},
            "edges: turn the grid to the direction most walls run in"},
           {"shift_x", &Params::shift_x, Range{-1, 1}, "shift of the grid, in cells"},
           {"shift_y", &Params::shift_y, Range{-1, 1}, "shift of the grid, in cells"},
           {"partial", &Params::partial, "also enter coarse cells of which only some sub-cells are free"}}});
}

}  // namespace oxturn
