/// Drives to cells in a given order by tethered shortest paths, then home.
///
///   const Path path = visit_cells(space, cells, order, parameters, context);
#pragma once

#include "algorithms/tethered/cell_parameters.hpp"
#include "algorithms/transit/tether_space.hpp"

namespace oxturn {

/// From the problem's start, with the tool on except on the way home; in a cell first its position, then its walls,
/// from their nearer ends. Promises the squares of the cells visited at their centres; the whole space, if all walls
/// are driven, cells are no larger than w / sqrt 2, and none is missed (tether_cells.hpp). When the path driven, pulled
/// taut, becomes longer than three tethers, the robot goes home along it first. Ends early if cancelled; publishes the
/// path so far whenever it has grown by a quarter. Records the figures cells_missed (cells to which no path keeps the
/// tether length limit) and paths_unproven (paths that may not be the shortest, because the search's budget ran out).
/// Traces "missed".
Path visit_cells(const TetherSpace& space, const TetherCells& cells, const CellList& order, const VisitParameters& how,
                 Context& context);

}  // namespace oxturn
