// Spanning tree coverage on a leash: round the shortest-path tree of coarse cells.
//
// Source      after Peng et al. 2025 (spanning tree coverage for tethered robots); Gabriely & Rimon 2001
// Model       grid of coarse cells 2D x 2D, offline, disc footprint
// Guarantee   each sub-cell of the tree's cells exactly once, closed, length n D for n sub-cells; string the geodesic all
//             along, at most depth * 2D + sqrt 2 * D in a coarse cell of that depth (plus the start's, if the anchor is
//             elsewhere); never over the own line
// Complexity  O(lattice)
// Decisions   1. The tree grows in the space cut open along the anchor's cut locus (leash.hpp). Round a tree in the
//                uncut space the string lies in the tree's class, which behind an obstacle may be the longer way.
//             2. The robot starts at a sub-cell's centre; of the four places of that sub-cell in its coarse cell the one
//                with most cells is taken.
//             3. `reach = depth`: cells with depth * 2D + sqrt 2 * D above the leash are left out. Along the lattice:
//                in the open that is a diamond. `reach = geodesic` (ours) keeps all, as the string is the geodesic and
//                configuration space ends at the leash.
#include <cmath>

#include "algorithms/lattice/coarse_cells.hpp"
#include "algorithms/transit/tether_space.hpp"
#include "algorithms/tethered/tether_cells.hpp"

namespace oxturn {
namespace {

struct Params {
  double cell_size = 0;
  std::string reach = "depth";
};

class TetheredStc final : public CoveragePlanner {
 public:
  explicit TetheredStc(Params p) : p_(std::move(p)) {}

  Path plan(const Problem& problem, Context& context) const override {
    const TetherSpace leash(problem, "tethered-stc");
    const double side = cell_side(p_.cell_size, problem.robot());
    const double left = leash.tether_length() - leash.field().distance(problem.start()) - std::sqrt(2.0) * side;
    if (p_.reach == "depth" && left < 0)
      throw Infeasible("the tether is too short for a round of one coarse cell; a smaller cell_size may help");
    const std::size_t deepest = p_.reach == "depth" ? static_cast<std::size_t>(left / (2 * side) + 1e-9)
                                                    : std::numeric_limits<std::size_t>::max();
    std::size_t most = 0;
    Polyline round;
    std::vector<Polyline> tree;
    for (const Point& shift : {Point(0, 0), Point(1, 0), Point(0, 1), Point(1, 1)}) {
      const GridGraph fine =
          make_grid_graph_at(leash.cut_space(), problem.map().name, problem.start() - side * shift, side);
      CoarseCells cells(fine);
      const Point at = fine.coordinates(problem.start());
      const int i = static_cast<int>(std::lround(at.x())), j = static_cast<int>(std::lround(at.y()));
      const std::size_t root = cells.at(i / 2, j / 2);
      if (!cells.free(root)) continue;
      const std::size_t count = grow_breadth_first(cells, root, deepest).size();
      if (count <= most) continue;
      most = count;
      // The start itself, not a rounded copy of it, at both ends.
      round = round_tree(fine, cells, i, j);
      round.front() = round.back() = problem.start();
      tree = tree_lines(cells);
    }
    if (most == 0)
      throw Infeasible("no coarse cell of twice the cell size fits about the start; a smaller cell_size may");
    if (context.wants_traces()) {
      context.trace("cut", leash.cut());
      context.trace("tree", std::move(tree));
    }
    PathBuilder path(problem.start());
    path.drive(round, true);
    return path.take();
  }

 private:
  Params p_;
};

}  // namespace

PlannerInfo tethered_stc() {
  return describe<TetheredStc, Params>(
      {.name = "tethered-stc",
       .family = "tethered",
       .title = "spanning tree coverage round the shortest-path tree",
       .citation = "after Peng et al. 2025",
       .capabilities = {Capability::tether, Capability::holes},
       .guarantee = "each sub-cell of the tree's cells exactly once, closed; string the geodesic, never driven over",
       .parameters = {
           {"cell_size", &Params::cell_size, Range{0, 1000}, "side D of a sub-cell, metres; 0: tool width / sqrt 2"},
           {"reach", &Params::reach, Choices{"depth", "geodesic"},
            "depth: the leash is measured along the tree; geodesic: along the string"}}});
}

}  // namespace oxturn
