/// What planners on a lattice promise to cover: the squares inscribed in the tool's disc about the centres of cells.
///
///   if (context.wants_promise()) promise_connected_cells(context, graph, start, tool_width);
///
/// A robot that visits the centre of a cell with the tool on covers that square whatever its path; of the cell's
/// corners it promises nothing. Squares are at most as large as the cells, so they do not overlap.
#pragma once

#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/lattice/grid_graph.hpp"

namespace oxturn {

/// Promises these cells. `tool_width` in metres. O(cells), when the region is asked for.
void promise_cells(Context& context, const GridGraph& graph, std::vector<Cell> cells, double tool_width);
/// Promises the cells that free lattice edges connect to `start`. Copies the graph, a byte for each node.
void promise_connected_cells(Context& context, const GridGraph& graph, const Cell& start, double tool_width);

}  // namespace oxturn
