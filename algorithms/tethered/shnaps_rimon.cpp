// Visits grid cells one by one, in the order of their distance along the tether.
//
// Source      after Shnaps and Rimon, "Online coverage by a tethered autonomous mobile robot in planar unknown
//             environments", IEEE T-RO 2014, as described by Berg 2021 (chapters 2 and 4.1)
// Model       grid, here offline, disc footprint of one cell
// Guarantee   visits every cell in which the robot fits (`cells`); the path, home included, is at most 2 L n for n
//             cells and a tether of L metres; keeps the tether length limit. With cells = partial the vertices of the
//             walls count as cells in this bound, and nothing that the tether reaches is left uncovered: of any point
//             of a cell, the segment to the cell's centre is free, or meets a wall that is driven, within w/2.
// Complexity  n cells: O(n log n) for their order, then n tethered shortest paths. With order = split nearly all of
//             them lead to a cell near by. With order = distance, as published, cells that follow one another lie
//             anywhere at the same distance from the anchor, so each path is about as long as the map is wide: all of
//             it grows as n^1.5 (the bound above, 2 L n, has the same order), and no search can take less than its
//             bends. A search looks at the area that its path spans.
// Decisions   1. Round k of the paper visits the new cells within k D, nearest first. Over all rounds that is one order
//                by (distance, row, column). Distances that differ by rounding alone count as equal.
//             2. `order = distance` is literal. As Berg 2021 shows, the path looks almost random.
//             3. `order = split`, the default, keeps the split cells, by which, as Berg 2021 says, one side of an
//                obstacle is finished before the other: see band_forest.hpp. The pieces of its forest are visited
//                depth-first, the nearest child first, the cells of a piece as in 1. Further trees (pockets, and cells
//                nearer to the anchor than the start) come last, the nearest first.
//             4. The paper's cells are wholly free and connected by free edges (`cells = joined`). By default a cell at
//                a wall counts as well: at its free point nearest to the centre, if that lies in the cell. According to
//                Berg 2021 the robot gets close to walls and into corners.
//             5. `cells = partial` (ours) leaves out no cell of which the robot reaches any part, and after a cell's
//                position drives the walls inside the cell, each from the nearer end.
//             6. All paths are driven with the tool on: scattered cells would not be covered otherwise.
#include "algorithms/online/survey_then_plan.hpp"
#include "algorithms/tethered/band_forest.hpp"
#include "algorithms/tethered/visit_cells.hpp"

namespace oxturn {
namespace {

enum class Order { distance, split };

struct Params : VisitParameters {
  Order order = Order::split;
};

Path plan(const Params& p, const Problem& problem, Context& context) {
  const TetherSpace space(problem, "shnaps-rimon");
  const TetherCells cells(problem, problem.configuration_space(), p.side(problem.robot()), p.cells);
  CellList order;
  if (p.order == Order::split) {
    ForestOrder forest = forest_order(cells, cells.side(), [&](CellList& piece) { sort_by_distance(piece, cells); });
    order = std::move(forest.cells);
    context.trace("tree of pieces", std::move(forest.edges));
  } else {
    for (std::size_t c = 0; c < cells.size(); ++c) order.push_back(c);
    sort_by_distance(order, cells);
  }
  return visit_cells(space, cells, order, p, context);
}

}  // namespace

PlannerInfo shnaps_rimon() {
  return with_sensing(
      describe<Params, plan>({.name = "shnaps-rimon",
                              .family = "tethered",
                              .title = "cell after cell by distance along the tether",
                              .citation = "after Shnaps & Rimon 2014",
                              .capabilities = {Capability::tether, Capability::holes},
                              .guarantee = "visits every cell; length at most 2 L n, home included",
                              .promise = Promise::cells,
                              .symmetries = {Symmetry::shift, Symmetry::scale},
                              .parameters = with_visit_parameters<Params>(
                                  {{"order", &Params::order, Choices{"distance", "split"},
                                    "distance: literal; split: one side of an obstacle is finished before the other"}}),
                              .published = {{"order", std::string("distance")}, {"cells", std::string("joined")}}}));
}

}  // namespace oxturn
