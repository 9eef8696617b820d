/// Cells in bands of similar tether distance, divided into pieces that form a forest.
///
///   const auto sort = [&](CellList& piece) { sort_by_distance(piece, cells); };
///   const ForestOrder forest = forest_order(cells, cells.side(), sort);
///   for (const std::size_t c : forest.cells) visit(cells[c]);
///
///     band 2    a a b b      Band k contains the cells at distances k D <= d < (k + 1) D, for bands of depth D. Its
///     band 1    a # # b      connected components are pieces. A component that several pieces of earlier bands lead
///     band 0     root        to (here behind the obstacle #) is divided where the paths to them are equally long. So
///                            one side of an obstacle is finished before the other: the split cells of Shnaps and
///                            Rimon.
///
/// Within a band, cells are adjacent over a side, or over a corner if a cell beside it is free to both: otherwise the
/// stairs of a grid would divide every slanting band.
#pragma once

#include <functional>

#include "algorithms/tethered/tether_cells.hpp"

namespace oxturn {

/// By (distance, row, column); distances that differ by rounding alone count as equal.
void sort_by_distance(CellList& list, const TetherCells& cells);

struct ForestOrder {
  CellList cells;
  std::vector<Polyline> edges;  // a segment from each piece to its parent: for pictures
};
/// All cells: depth-first over the pieces, the nearest child first. The tree of the start comes first, then the other
/// trees (pieces that no earlier band leads to), always the nearest one. `depth` of bands: metres. `sort` brings the
/// cells of a piece into order. O(n log n) for n cells, and the other trees that are looked at.
ForestOrder forest_order(const TetherCells& cells, double depth, const std::function<void(CellList&)>& sort);

}  // namespace oxturn
