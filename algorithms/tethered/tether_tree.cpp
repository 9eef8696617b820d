// Goes there and back along a shortest-path tree of cells, so that the tether cannot tangle.
//
// Source      after Sharma, Poudel, Dutta, Zeinali, Talaei Khoei and Kim, "A 2-approximation algorithm for the online
//             tethered coverage problem", RSS 2019, whose online walk stays within twice the optimum
// Model       grid, here offline, disc footprint of one cell
// Guarantee   visits every cell whose depth in the tree the tether allows; length exactly 2 (n - 1) D for n cells, home
//             included; the tether is never longer than at the start plus the cell's depth, and never tangled.
//             partial = true: visits every cell whose centre is free and no deeper than the tether allows, and drives
//             the walls as far as it allows (all of them, with reach = geodesic), in every component of the cut space
//             (tether_space.hpp); so nothing is left uncovered but what cannot be entered. The length is twice that of
//             what is driven: at most 2 (n D + P + k D) for walls P metres long and k edges of the lattice that end at
//             walls. The tether is the geodesic throughout: no longer than at the start plus the distance from there
//             along the path's own tree, which is a path in the cut space. Proof: wall_tree.hpp, tether_space.hpp.
// Complexity  O(lattice nodes), and n queries of the geodesic field; partial = true: O((n + v) log (n + v)) for v
//             vertices of the cut space
// Decisions   1. The tree is breadth-first over the cells (neighbours counter-clockwise from east), rooted at the
//                start: depth is the shortest path along the lattice.
//             2. `reach = depth`: cells deeper than the tether is long are omitted, as in the paper. Depth is measured
//                along the lattice, so in the open the cells form a diamond.
//             3. `reach = geodesic` (ours): the tree grows in the space cut open along the anchor's cut locus. There
//                the tether is the geodesic whatever the path, so all cells within the tether's reach stay.
//             4. The walk visits children in the order in which they were found, always with the tool on.
//             5. `partial = true` (ours) always plans in the cut space. The sides of the cut are driven only where the
//                cell's centre cannot be. Of equally short paths to a cell the straightest is taken.
#include "algorithms/lattice/promised_cells.hpp"
#include "algorithms/online/survey_then_plan.hpp"
#include "algorithms/tethered/cell_parameters.hpp"
#include "algorithms/tethered/wall_tree.hpp"
#include "algorithms/transit/short_segments.hpp"
#include "algorithms/transit/tether_space.hpp"
#include "base/graph_search.hpp"

namespace oxturn {
namespace {

struct Params : TreeParameters {
  bool partial = false;
};

constexpr double kRounding = 1e-9;  // cell sides

using Children = std::vector<CellList>;  // by cell

/// The breadth-first tree from the root, no deeper than `deepest`.
Children shortest_path_tree(const TetherCells& cells, std::size_t deepest) {
  const std::size_t unreached = cells.size();
  Children children(cells.size());
  CellList depth(cells.size(), unreached), queue{cells.root()};
  depth[cells.root()] = 0;
  const auto at_limit = [&](std::size_t c) { return depth[c] >= deepest; };
  const auto expand = [&](std::size_t at, auto reach) {
    for (const Direction d : kAllDirections) {
      const auto n = cells.neighbour(at, d);
      if (!n || depth[*n] < unreached) continue;
      depth[*n] = depth[at] + 1;
      children[at].push_back(*n);
      reach(*n);
    }
  };
  breadth_first(queue, expand, at_limit);
  return children;
}

/// Depth-first and back to the root, with an explicit stack: a corridor is a deep tree.
Path walk(const Problem& problem, const TetherCells& cells, const Children& children, Context& context) {
  struct Step {
    std::size_t cell, next_child = 0;
  };
  PathBuilder path(problem.start());
  std::vector<Step> stack{{cells.root()}};
  while (!context.cancelled()) {
    Step& top = stack.back();
    if (top.next_child < children[top.cell].size()) {
      stack.push_back({children[top.cell][top.next_child++]});
    } else {
      stack.pop_back();
      if (stack.empty()) break;
    }
    path.drive(cells[stack.back().cell].at, true);
  }
  return path.take();
}

/// All cells of the tree.
CellList visited(const TetherCells& cells, const Children& children) {
  CellList list{cells.root()};
  for (const CellList& of_cell : children) list.insert(list.end(), of_cell.begin(), of_cell.end());
  return list;
}

std::vector<Polyline> edges_of(const TetherCells& cells, const Children& children) {
  std::vector<Polyline> lines;
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const std::size_t child : children[c]) lines.push_back({cells[c].at, cells[child].at});
  return lines;
}

Path visit_free_cells(const Params& p, const TetherSpace& space, Context& context) {
  const Problem& problem = space.problem();
  const bool geodesic = p.reach == TreeReach::geodesic;
  const TetherCells cells(problem, geodesic ? space.cut_space() : problem.configuration_space(),
                          p.side(problem.robot()), CellKind::joined);
  const double remaining = space.tether_length() - cells[cells.root()].distance;
  const auto deepest = geodesic ? cells.size() : static_cast<std::size_t>(remaining / cells.side() + 1e-9);
  if (deepest == 0)
    throw Infeasible("the tether does not reach the cells beside that of the start; a smaller cell_size may help");
  const Children children = shortest_path_tree(cells, deepest);
  promise_cells(context, cells.lattice(), cells.central(visited(cells, children)), problem.robot().tool_width);
  if (context.wants_traces()) context.trace("tree", edges_of(cells, children));
  return walk(problem, cells, children, context);
}

/// All walls are driven: everything that can be entered. Otherwise the cells of the start's component.
void promise(Context& context, const TetherSpace& space, double side, bool all, const WallTree& first) {
  const double w = space.problem().robot().tool_width;
  if (!all || side > w / std::sqrt(2.0) * (1 + kRounding))
    return promise_cells(context, first.lattice(), first.cells(), w);
  Region region;
  for (const TetherSpace::Component& component : space.components())
    for (const Polygon& polygon : component.problem.configuration_space().polygons) region.polygons.push_back(polygon);
  promise_region(context, std::move(region));
}

Path visit_cells_and_walls(const Params& p, const TetherSpace& space, Context& context) {
  const EdgeIndex& walls = space.problem().walls();
  const double side = p.side(space.problem().robot());
  const bool all = p.reach == TreeReach::geodesic;
  const auto is_wall = [&, tolerance = space.problem().tolerance()](const Point& a, const Point& b) {
    return walls.nearest(lerp(a, b, 0.5), tolerance).has_value();
  };
  const auto cover = [&](const TetherSpace::Component& component, Context& inner) {
    const Point& start = component.problem.start();
    const double remaining = space.tether_length() - space.field().distance(start);
    const WallTree tree(component.problem, side, all ? std::numeric_limits<double>::infinity() : remaining, is_wall);
    if (component.index == 0) promise(context, space, side, all, tree);
    if (inner.wants_traces()) inner.trace("tree", tree.branches());
    const Polyline line = tree.path();
    if (line.size() < 2)
      throw Infeasible("the tether reaches no cell and no wall beside the start; a smaller cell_size may help");
    PathBuilder path(start);
    path.drive(line, true);
    return without_short_segments(path.take(), component.problem);
  };
  return cover_components(space, cover, true, context);
}

Path plan(const Params& p, const Problem& problem, Context& context) {
  const TetherSpace space(problem, "tether-tree");
  if (context.wants_traces()) context.trace("cut", space.cut());
  return p.partial ? visit_cells_and_walls(p, space, context) : visit_free_cells(p, space, context);
}

}  // namespace

PlannerInfo tether_tree() {
  return with_sensing(describe<Params, plan>(
      {.name = "tether-tree",
       .family = "tethered",
       .title = "there and back along a shortest-path tree of cells",
       .citation = "after Sharma et al. 2019",
       .capabilities = {Capability::tether, Capability::holes},
       .guarantee = "every cell no deeper than the tether is long, in exactly 2 (n - 1) D; never tangled",
       .promise = Promise::cells,
       .symmetries = {Symmetry::shift, Symmetry::quarter_turn, Symmetry::mirror, Symmetry::scale},
       .parameters = with_tree_parameters<Params>(
           {{"partial", &Params::partial,
             "also drive the walls, so that cells which are not entirely free are covered"}})}));
}

}  // namespace oxturn
