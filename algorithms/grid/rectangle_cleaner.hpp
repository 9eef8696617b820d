/// MyCarbot (TH Nuernberg) in a known world: partitions it, drives from rectangle to rectangle and cleans each column
/// by column.
///
///   Path path = clean_rectangles(options, problem, graph, std::vector<bool>(graph.size(), false), context).path;
///
/// Costs: see rectangles.cpp.
#pragma once

#include <algorithm>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/grid/rectangle_world.hpp"
#include "algorithms/lattice/grid_options.hpp"
#include "algorithms/lattice/lattice_paths.hpp"

namespace oxturn {

enum class NextRectangle { first, nearest };
enum class ColumnStep { each, tool };
enum class Lanes { straight, diagonal };
enum class CellsAs { wider, robot };

/// Parameters of `rectangles`; what they mean is in its description.
struct RectangleOptions : CellOptions {
  NextRectangle choose = NextRectangle::nearest;
  CellsAs cells = CellsAs::wider;
  ColumnStep columns = ColumnStep::tool;
  ScanOrder scan = ScanOrder::columns;
  Lanes lanes = Lanes::straight;
  int smallest = 1;
  int gap = 1;
  int small_obstacle = 4;
  int shift = 4;
  bool via_centre = true;
  bool revisit_skipped = false;

  /// Metres: `cell_size`; if that is 0, half the width of the robot or of its tool, whichever is wider.
  double side(const Robot& robot) const {
    if (cell_size > 0) return cell_size;
    return cells == CellsAs::robot ? robot_size(robot) : std::max(robot_size(robot), robot.tool_width / 2);
  }
  /// Cells that a rectangle needs on each side: `smallest`; if that is 0 two, or one if cells are as wide as the robot.
  int cells_needed(const Robot& robot) const {
    if (smallest > 0) return smallest;
    return side(robot) >= 2 * robot_size(robot) ? 1 : 2;
  }
};

struct CleanedRectangles {
  Path path;                        // empty if no rectangle can be driven
  std::size_t rectangles = 0;       // driven
  std::size_t skipped_columns = 0;  // where the robot does not fit
  std::size_t skipped_cells = 0;    // in skipped columns and below shifted starts
  std::size_t small_cells = 0;      // in rectangles that are too small to be driven
};
/// `graph`: the lattice over the problem's configuration space. `done`: nodes that have been cleaned before.
CleanedRectangles clean_rectangles(const RectangleOptions& options, const Problem& problem, const GridGraph& graph,
                                   std::vector<bool> done, Context& context);

}  // namespace oxturn
