/// Configuration space and target in square cells, with the distance of each cell from the start. Private to metrics/.
///
///   const std::optional<LevelCells> cells = level_cells(problem, 1.0 / 8, 1e5);
///
/// Lengths are in tool widths, areas in their squares. The cells lie along the longest edge of the target, so that a
/// map has the same ones however it is turned. Configuration space is taken a little too large (by 1/1000), so that it
/// holds every valid path in spite of rounding and of the chords of its arcs.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "maps/problem.hpp"

namespace oxturn {

struct LevelCells {
  struct Cell {
    int column, row;
    double low, high;  // of the geodesic distance from the start, over all points of configuration space in the cell
  };
  struct Part {
    int column, row;
    double area;  // of the target in the cell
  };
  static constexpr std::int32_t kNone = -1;

  double side = 1;  // of a cell
  int columns = 0, rows = 0;
  std::vector<Cell> cells;       // that meet configuration space
  std::vector<Part> parts;       // of the target
  std::vector<std::int32_t> at;  // index into `cells`, row by row
  std::int32_t start = kNone;    // the cell in which a path begins

  std::int32_t cell(int column, int row) const {
    if (column < 0 || row < 0 || column >= columns || row >= rows) return kNone;
    return at[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column)];
  }
};

/// A superset of where the robot's centre may be, a little larger: the component that holds the start. Empty: it is not
/// known.
Region wide_space(const Problem& problem);

/// nullopt for a robot with a polygonal footprint or smaller than a thousandth of the tool, where there would be more
/// than `most` cells in the bounding box, and where configuration space has no narrow part: nothing longer than a few
/// tool widths that a square about as wide as the tool does not fit into. O(n log n) for n vertices, and a query of the
/// geodesic field for each cell.
std::optional<LevelCells> level_cells(const Problem& problem, double side, double most);

}  // namespace oxturn
