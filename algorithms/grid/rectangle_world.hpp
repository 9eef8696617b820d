// MyCarbot's world: a grid of wall and free cells, its gaps mended, cut into rectangles from the lower left.
//
// Pure grid functions, known to nothing of robots. `free` has a bit for each cell that may be cleaned.
#pragma once

#include <vector>

#include "geometry/raster.hpp"

namespace oxturn {

/// Columns [left, right], rows [bottom, top], all included.
struct CellRectangle {
  int left = 0, bottom = 0, right = -1, top = -1;
  int width() const { return right - left + 1; }
  int height() const { return top - bottom + 1; }
  bool operator==(const CellRectangle&) const = default;
};

/// "Lueckenbehebung": free runs of at most `gap` cells between two wall cells, in a row or a column, become wall;
/// then the missing corners of small obstacles (bounding box at most `small` cells a side) are filled: a free cell
/// that has a cell of such an obstacle both beside and above or below it. O(cells).
BitGrid without_gaps(const BitGrid& free, int gap, int small);

/// "Welt partitionieren": the first free cell from the lower left (row by row, or column by column) starts a rectangle; its
/// height is the free run upwards; it grows to the right while the next column has that much room. Repeated until no
/// cell is left. O(cells). Rectangles are disjoint and cover all free cells.
/// Taking a rectangle's cells away leaves the others as they are, so nothing is gained by doing this anew after each.
std::vector<CellRectangle> rectangles_of(const BitGrid& free, bool by_rows);

}  // namespace oxturn
