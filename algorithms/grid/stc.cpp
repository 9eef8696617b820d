// Offline spanning tree coverage: around a tree of coarse cells, each sub-cell once.
//
// Source      Gabriely & Rimon, "Spanning-tree based coverage of continuous areas by a mobile robot", ICRA 2001
// Model       grid of coarse cells 2D x 2D, offline, disc footprint
// Guarantee   each sub-cell (side D) of the free coarse cells connected to the first one exactly once; the path is
//             closed and its length is the number of sub-cells times D
// Complexity  n sub-cells: time and memory O(n), `weighted` O(n log n). The same with `components = all`, or O(n log n)
//             and a short shortest path for each component where only paths that leave the lattice connect them
// Decisions   1. A coarse cell is free if the square through its four sub-cell centres lies in configuration space,
//                because nothing else is driven inside it. Two are adjacent if both lattice edges between their
//                sub-cells are free.
//             2. D defaults to w / sqrt 2, so that a disc tool covers each sub-cell from its centre line; the paper's
//                square tool is cell_size = w.
//             3. The paper starts in a cell. Here the robot first drives the shortest path to the nearest sub-cell.
//             4. `components = all` (ours) also covers the other connected components of the free coarse cells: where
//                the path passes the point that is nearest to another component, the robot goes there, around it, and
//                back (component_order.hpp). `start` is the paper.
//             5. The tree: see TreeKind in spanning_trees.hpp.
//             6. `partial = true` (after the same authors, 2002 and 2003): partly occupied coarse cells are entered,
//                too. Every sub-cell that free lattice edges connect to the first is visited; length <= (n + m) D
//                (sub_cell_tree.hpp).
#include <utility>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/grid/component_order.hpp"
#include "algorithms/lattice/linked_rounds.hpp"
#include "algorithms/lattice/partial_stc.hpp"
#include "algorithms/lattice/promised_cells.hpp"
#include "algorithms/lattice/spanning_trees.hpp"

namespace oxturn {
namespace {

struct Params : TreeOptions {
  bool partial = false;
};

LinkedRounds::Link link_to(const ComponentOrder::Entry& entry) { return {entry.from, entry.at, &entry.path}; }

Path plan(const Params& p, const Problem& problem, Context& context) {
  const GridGraph fine = p.lattice(problem, 2);
  if (p.partial) return cover_partial_cells(problem, fine, p, context);
  CoarseCells cells(fine);
  const ConnectedComponents components = components_of(cells);
  if (components.count == 0) throw Infeasible("no coarse cell of twice the cell size fits; a smaller cell_size may");

  LatticePaths paths(fine, problem.walls());
  ComponentOrder order(problem, fine, cells, components, paths);
  TreeGrower grower(cells, p.tree, context.rng());
  PathBuilder path(problem.start());
  if (const std::optional<ComponentOrder::Entry> root = order.first()) {
    const Cell base{root->at.i & ~1, root->at.j & ~1};
    promise_coarse_cells(context, fine, p.components, base, problem.robot().tool_width);
    std::vector<ComponentOrder::Entry> branches;
    if (p.components == Components::all) branches = order.branches();
    grower.grow(root->coarse);
    for (const ComponentOrder::Entry& branch : branches) grower.grow(branch.coarse);
    std::vector<LinkedRounds::Link> links;
    for (const ComponentOrder::Entry& branch : branches) links.push_back(link_to(branch));
    LinkedRounds(fine, std::move(links), path).drive(link_to(*root), context, [&](const Cell& c) {
      return steps_around(cells, c);
    });
  }
  if (context.wants_traces()) context.trace("tree", tree_lines(cells));
  return path.take();
}

}  // namespace

PlannerInfo stc() {
  return describe<Params, plan>(
      {.name = "stc",
       .family = "grid",
       .title = "spanning tree coverage, offline",
       .citation = "Gabriely & Rimon 2001",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "each sub-cell of the free coarse cells exactly once, on a closed path",
       .promise = Promise::cells,
       .symmetries = {Symmetry::shift, Symmetry::scale},
       .parameters = with_tree_options<Params>(
           {{"partial", &Params::partial, "also enter coarse cells of which only some sub-cells are free"}}),
       .published = {{"components", "start"}}});
}

}  // namespace oxturn
