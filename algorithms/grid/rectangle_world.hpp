/// The world of MyCarbot (TH Nuernberg): a grid of wall and free cells, its gaps closed, partitioned into rectangles
/// from the lower left.
///
///   const BitGrid world = without_gaps(free, 1, 4);
///   for (const CellRectangle& r : rectangles_of(world, ScanOrder::columns)) ...
///
///   . . 2 2 2       three rectangles, in the order of ScanOrder::columns
///   1 1 # # 3
///   1 1 # # 3
///
/// Pure functions on grids. `free` has a bit for each cell that may be cleaned.
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

/// "Lueckenbehebung": free runs of at most `gap` cells between two wall cells in a row or a column become wall. Then
/// the missing corners of small obstacles (bounding box at most `small` cells a side) are filled: free cells that have
/// a cell of the same such obstacle both beside and above or below them. O(cells).
BitGrid without_gaps(const BitGrid& free, int gap, int small);

enum class ScanOrder { columns, rows };
/// "Welt partitionieren": the first free cell from the lower left, in the given order, starts a rectangle. Its height
/// is the free run upwards; it grows to the right while the next column has that much room. Repeated until no cell is
/// left. O(cells). Rectangles are disjoint and cover all free cells. Removing one rectangle's cells leaves the others
/// as they are, so a new partition after each rectangle would give the same.
std::vector<CellRectangle> rectangles_of(const BitGrid& free, ScanOrder order);

}  // namespace oxturn
