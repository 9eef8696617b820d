/// Conversion between regions and grids of cells.
///
///   const BitGrid grid = rasterise(region, {0, 0}, 0.05, 400, 300, CellRule::inside);
///   const Region outline = simplify_inward(trace(grid), 0.05);
#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/region.hpp"

namespace oxturn {

/// columns x rows cells of side `cell`. Cell (i, j) is the square from origin + (i, j) * cell to
/// origin + (i + 1, j + 1) * cell; row 0 is the lowest.
struct BitGrid {
  Point origin{0, 0};
  double cell = 1;  // metres
  int columns = 0, rows = 0;
  std::vector<std::uint8_t> bits;  // row by row; 1: set

  BitGrid() = default;
  BitGrid(const Point& origin_, double cell_, int columns_, int rows_)
      : origin(origin_),
        cell(cell_),
        columns(columns_),
        rows(rows_),
        bits(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {}
  bool inside(int i, int j) const { return i >= 0 && j >= 0 && i < columns && j < rows; }
  std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i);
  }
  /// False outside the grid.
  bool get(int i, int j) const { return inside(i, j) && bits[at(i, j)] != 0; }
  void set(int i, int j, bool value) { bits[at(i, j)] = value ? 1 : 0; }
  Point centre(int i, int j) const { return origin + cell * Point(i + 0.5, j + 0.5); }
  /// The number of set cells.
  std::size_t count() const;
};

/// Which cells a region sets.
enum class CellRule {
  centre,   // those whose centre lies in the closed region
  inside,   // those that lie in the closed region as a whole
  touches,  // those whose open square meets the region's interior
};
/// `centre` is decided by exact predicates; for the other rules coordinates within 1e-9 cells of a grid line count as
/// on it. O(cells + edges + boundary cells).
BitGrid rasterise(const Region& region, const Point& origin, double cell, int columns, int rows, CellRule rule);

/// The set cells as a region. Its vertices are lattice points, collinear ones left out. Set cells that share only a
/// corner are not connected (free space is 4-connected, walls 8-connected), and no ring touches itself. O(cells).
Region trace(const BitGrid& grid);

/// A union of squares of side `cell` that contains all points within `reach` of the segments (of two points each).
/// O(cells of their bounding box, and cells within `reach` of each sample of a segment).
Region squares_around(const std::vector<Polyline>& segments, double reach, double cell);

/// Removes vertices where that removes free space and never adds any: convex vertices, as long as they stay within
/// `tolerance` of the new boundary, and exactly collinear ones. Rings never cross. O(n log n) for usual data, and at
/// worst the number of removed vertices for each new edge. With a box it removes convex vertices only where the
/// triangle that this cuts off lies in the box: so holes that do not meet the box may be missing from the region.
Region simplify_inward(const Region& region, double tolerance);
Region simplify_inward(const Region& region, double tolerance, const Box& within);

}  // namespace oxturn
