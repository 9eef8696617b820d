/// What planners on a lattice promise to cover: the squares inscribed in the tool's disc about the centres of cells.
///
///   promise_free_cells(context, graph, p_.components, entry->cell, tool_width);
///
/// A robot that visits the centre of a cell with the tool on covers that square whatever its path; of the cell's
/// corners it promises nothing. Squares are at most as large as the cells, so they do not overlap.
///
/// Which cells these are is found out in O(nodes) when the region is asked for, after the run; until then the graph is
/// copied, a byte for each node.
#pragma once

#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/lattice/grid_options.hpp"

namespace oxturn {

/// Promises all free cells, or those that free lattice edges connect to `first`. `tool_width` in metres.
void promise_free_cells(Context& context, const GridGraph& graph, Components components, const Cell& first,
                        double tool_width);
/// The same for the sub-cells of free coarse cells of two by two (coarse_cells.hpp). `first`: the lower left sub-cell
/// of a coarse cell.
void promise_coarse_cells(Context& context, const GridGraph& fine, Components components, const Cell& first,
                          double tool_width);

/// Promises the squares of these cells.
void promise_cells(Context& context, const GridGraph& graph, std::vector<Cell> cells, double tool_width);
/// Promises a region.
void promise_region(Context& context, Region region);

/// The sub-cells of the free coarse cells.
std::vector<Cell> coarse_sub_cells(const GridGraph& fine, Components components, const Cell& first);
/// The squares of these cells. Where they are as large as the cells, neighbours in a row are one rectangle: of millions
/// of cells, most of the memory is saved, and half of the time to measure how much of them was covered.
Region squares_of(const GridGraph& graph, std::vector<Cell> cells, double tool_width);

}  // namespace oxturn
