// Spanning tree coverage, offline: round a tree of coarse cells, each sub-cell once.
//
// Source      Gabriely & Rimon, "Spanning-tree based coverage of continuous areas by a mobile robot", ICRA 2001
// Model       grid of coarse cells 2D x 2D, offline, disc footprint
// Guarantee   each sub-cell (side D) of the free coarse cells connected to the first one exactly once; the round
//             is closed and its length is the number of sub-cells times D
// Complexity  n sub-cells: time and memory O(n), `weighted` O(n log n); the same with `components = all`
//             unless parts hang together by ways between the lattice's lines only
// Decisions   1. A coarse cell is free if the square through its four sub-cell centres, which is all that is driven
//                inside it, lies in configuration space; two are adjacent if both ways between them do.
//             2. D defaults to w / sqrt 2, so that a disc tool covers each sub-cell from its centre line; the
//                paper's square tool is cell_size = w.
//             3. The paper starts in a cell. Here the robot first drives the shortest way to the nearest sub-cell.
//             4. `components = all` (ours) takes in the other parts of the free coarse cells: where the round comes by the
//                place that is nearest to another part, the robot goes there, round it, and back (part_order.hpp); `start`
//                is the paper.
//             5. The tree: breadth-first (counter-clockwise from east), depth-first, `minimum-turn` (depth-first
//                that goes straight on while it can), `random`, `weighted` (minimum spanning tree, vertical edges
//                dearer: long horizontal lanes).
//             6. `partial = true` (after the same authors, 2002/2003): partly occupied coarse cells are entered, too; every
//                sub-cell that free steps join to the first is visited, length <= (n + m) D (sub_cell_tree.hpp).
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/grid/coarse_components.hpp"
#include "algorithms/grid/component_order.hpp"
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

    LatticePaths ways(fine, problem.walls());
    PartOrder order(problem, fine, cells, parts, ways);
    TreeGrower grower(cells, p_.tree, context.rng());
    PathBuilder path(problem.start());
    int done = 0;
    for (auto root = order.first(); root && !context.cancelled(); root = order.next(path.at())) {
      std::vector<PartOrder::Entry> branches;
      if (p_.components == "all") branches = order.branches();
      grower.grow(root->coarse);
      for (const PartOrder::Entry& branch : branches) grower.grow(branch.coarse);
      path.drive(root->way, false);
      drive_round(fine, cells, *root, branches, path, context);
      done += 1 + static_cast<int>(branches.size());
      context.progress(double(done) / parts.count);
      if (p_.components == "start") break;
    }
    if (context.wants_traces()) context.trace("tree", tree_lines(cells));
    return path.take();
  }

 private:
  // Round the tree from the root; where the way to another part begins, there and round that part first.
  static void drive_round(const GridGraph& fine, const CoarseCells& cells, const PartOrder::Entry& root,
                          const std::vector<PartOrder::Entry>& branches, PathBuilder& path, Context& context) {
    constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> first(branches.empty() ? 0 : fine.size(), kNone), next(branches.size(), kNone);
    for (std::size_t k = branches.size(); k-- > 0;)
      next[k] = std::exchange(first[branches[k].from], static_cast<std::uint32_t>(k));
    struct Round {
      const PartOrder::Entry* part;
      int i, j;
      std::uint32_t branch;  // the next to be driven from here
    };
    const auto branch_at = [&](int i, int j) { return first.empty() ? kNone : first[fine.at(i, j)]; };
    std::vector<Round> open{{&root, root.i, root.j, branch_at(root.i, root.j)}};
    Polyline line{fine.centre(root.i, root.j)};
    std::optional<Direction> last;
    const auto go = [&](const Polyline& way) {
      path.drive(line, true);
      path.drive(way, false);
      line.assign(1, way.back());
      last.reset();
    };
    while (!open.empty() && !context.cancelled()) {
      Round& here = open.back();
      if (here.branch != kNone) {
        const PartOrder::Entry& part = branches[here.branch];
        here.branch = next[here.branch];
        go(part.way);
        open.push_back({&part, part.i, part.j, branch_at(part.i, part.j)});
        continue;
      }
      const Direction d = round_step(cells, here.i, here.j);
      here.i += kColumnStep[d];
      here.j += kRowStep[d];
      if (last == d) line.pop_back();
      line.push_back(fine.centre(here.i, here.j));
      last = d;
      if (here.i != here.part->i || here.j != here.part->j) {
        here.branch = branch_at(here.i, here.j);
        continue;
      }
      const PartOrder::Entry* part = here.part;  // round
      open.pop_back();
      if (!open.empty()) go(Polyline(part->way.rbegin(), part->way.rend()));
    }
    path.drive(line, true);
  }

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
