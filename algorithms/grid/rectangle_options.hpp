/// Parameters of `rectangles`, and what follows from them for a robot.
///
///   RectangleOptions options;
///   const double metres = options.side(problem.robot());   // of a cell
#pragma once

#include <algorithm>

#include "algorithms/grid/rectangle_world.hpp"
#include "algorithms/lattice/grid_options.hpp"

namespace oxturn {

enum class NextRectangle { first, nearest };
enum class ColumnStep { each, tool };
enum class Lanes { straight, diagonal };
enum class Along { columns, longer };
enum class CellsAs { wider, robot };

/// Parameters of `rectangles`; what they mean is in its description.
struct RectangleOptions : CellSize {
  Align align = Align::axes;  // with a lidar, edges are those of the walls seen first
  Sensing sensing = Sensing::map;
  NextRectangle choose = NextRectangle::nearest;
  CellsAs cells = CellsAs::wider;
  ColumnStep columns = ColumnStep::tool;
  Along along = Along::longer;
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
  /// Cells from one lane to the next one.
  int lane_distance(const Robot& robot) const {
    const int under_tool = static_cast<int>(robot.tool_width / side(robot) + 1e-9);
    return columns == ColumnStep::tool ? std::max(1, under_tool) : 1;
  }
  /// Cells that a rectangle needs on each side: `smallest`; if that is 0 two, or one if cells are as wide as the robot.
  int cells_needed(const Robot& robot) const {
    if (smallest > 0) return smallest;
    return side(robot) >= 2 * robot_size(robot) ? 1 : 2;
  }
};

}  // namespace oxturn
