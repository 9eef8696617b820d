// There and back along a shortest-path tree of cells: a tether cannot tangle.
//
// Source      after Sharma, Dutta, Kim, "Optimal online coverage path planning with energy constraints", AAMAS 2019,
//             whose online walk keeps within twice the optimum
// Model       grid, here offline, disc footprint of one cell
// Guarantee   every cell no deeper in the tree than the leash is long; length exactly 2 (n - 1) D for n cells, home
//             included; string never longer than the start's and the cell's depth; never tangled
// Complexity  O(lattice + n), and n questions to the geodesic field
// Decisions   1. The tree is breadth-first over the cells (counter-clockwise from east), rooted at the start's: depth is
//                the shortest way along the lattice.
//             2. `reach = depth`: cells deeper than the leash are left out, as the paper's energy budget does. That is
//                measured along the lattice: in the open it is a diamond.
//             3. `reach = geodesic` (ours): the tree grows in the space cut open along the anchor's cut locus, where the
//                string is the geodesic whatever the way; so all cells stay that the leash reaches.
//             4. The walk takes children as they were found. It is all driven with the tool on.
#include <algorithm>
#include <cmath>

#include "algorithms/online/sensing.hpp"
#include "algorithms/transit/tether_space.hpp"
#include "algorithms/tethered/tether_cells.hpp"

namespace oxturn {
namespace {

struct Params {
  double cell_size = 0;
  std::string reach = "depth";
};

class TetherTree final : public CoveragePlanner {
 public:
  explicit TetherTree(Params p) : p_(std::move(p)) {}

  Path plan(const Problem& problem, Context& context) const override {
    const TetherSpace leash(problem, "tether-tree");
    const bool geodesic = p_.reach == "geodesic";
    const TetherCells cells(problem, geodesic ? leash.cut_space() : problem.configuration_space(),
                            cell_side(p_.cell_size, problem.robot()), CellKind::joined);
    const double left = leash.tether_length() - cells[cells.root()].distance;
    const auto deepest = geodesic ? cells.size() : static_cast<std::size_t>(left / cells.side() + 1e-9);
    if (deepest == 0)
      throw Infeasible("the tether does not reach the cells beside the start's; a smaller cell_size may");
    const std::vector<std::vector<std::size_t>> children = grow(cells, deepest);
    if (context.wants_traces()) context.trace("tree", tree_lines(cells, children));
    return walk(problem, cells, children, context);
  }

 private:
  static std::vector<std::vector<std::size_t>> grow(const TetherCells& cells, std::size_t deepest) {
    std::vector<std::vector<std::size_t>> children(cells.size());
    std::vector<std::size_t> depth(cells.size(), cells.size()), queue{cells.root()};
    depth[cells.root()] = 0;
    for (std::size_t k = 0; k < queue.size() && depth[queue[k]] < deepest; ++k)
      for (const Direction d : kAllDirections) {
        const auto n = cells.neighbour(queue[k], d);
        if (!n || depth[*n] < cells.size()) continue;
        depth[*n] = depth[queue[k]] + 1;
        children[queue[k]].push_back(*n);
        queue.push_back(*n);
      }
    return children;
  }

  // Depth-first without recursion: a corridor is a deep tree.
  static Path walk(const Problem& problem, const TetherCells& cells,
                   const std::vector<std::vector<std::size_t>>& children, Context& context) {
    struct Step {
      std::size_t cell, next = 0;
    };
    PathBuilder path(problem.start());
    std::vector<Step> stack{{cells.root()}};
    while (!context.cancelled()) {
      Step& top = stack.back();
      if (top.next < children[top.cell].size()) {
        stack.push_back({children[top.cell][top.next++]});
      } else {
        stack.pop_back();
        if (stack.empty()) break;
      }
      path.drive(cells[stack.back().cell].place, true);
    }
    return path.take();
  }

  static std::vector<Polyline> tree_lines(const TetherCells& cells,
                                          const std::vector<std::vector<std::size_t>>& children) {
    std::vector<Polyline> lines;
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (const std::size_t child : children[c]) lines.push_back({cells[c].place, cells[child].place});
    return lines;
  }

  Params p_;
};

}  // namespace

PlannerInfo tether_tree() {
  return with_sensing(describe<TetherTree, Params>(
      {.name = "tether-tree",
       .family = "tethered",
       .title = "there and back along a shortest-path tree of cells",
       .citation = "after Sharma et al. 2019",
       .capabilities = {Capability::tether, Capability::holes},
       .guarantee = "every cell no deeper than the leash, in exactly 2 (n - 1) D; never tangled",
       .parameters = {
           {"cell_size", &Params::cell_size, Range{0, 1000}, "side D of a cell, metres; 0: tool width / sqrt 2"},
           {"reach", &Params::reach, Choices{"depth", "geodesic"},
            "depth: the leash is measured along the tree; geodesic: along the string, in the cut space"}}}));
}

}  // namespace oxturn
