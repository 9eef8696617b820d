/// The fewest straight runs, each along a row or a column, that make up a set of cells.
///
///   const std::vector<CellRun> runs = fewest_runs(cells, false);
///   for (const CellRun& r : runs) ...                        // disjoint, together all set cells
///
/// Each cell is horizontal or vertical; a run is a maximal sequence of cells of that orientation along it. A run has
/// one right (or lower) end, so the number of runs is the sum over cells of [x = 1, right neighbour not 1] and
/// [x = 0, lower neighbour not 0], x = 1 for horizontal ones. This is the capacity of a cut (each cell's edges to its
/// right and from its lower neighbour, or to the sink and from the source), so a minimum cut is the optimum.
///
/// After Ramesh, Imeson, Fidan and Smith 2022, who solve the linear program. O(n) memory; the flow (Boykov and
/// Kolmogorov 2004) takes about linear time on such graphs, but longer in large empty areas: rows side by side with the
/// same cells are one row of it, and so are columns.
#pragma once

#include <vector>

#include "geometry/raster.hpp"

namespace oxturn {

struct CellRun {
  bool horizontal = true;
  int line = 0;             // row, or column of a vertical run
  int first = 0, last = 0;  // columns, or rows of a vertical run; both included
  friend bool operator==(const CellRun&, const CellRun&) = default;
};

/// `compact`: of the optima one with the fewest pairs of neighbours of different orientation; else the one with the
/// fewest horizontal cells. Horizontal runs first, by line, then by first cell.
std::vector<CellRun> fewest_runs(const BitGrid& cells, bool compact);

}  // namespace oxturn
