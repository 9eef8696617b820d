// A region as bits on a grid, and back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

/// columns x rows cells of side `cell`; cell (i, j) is the square from origin + (i, j) * cell to
/// origin + (i + 1, j + 1) * cell. Row 0 is the lowest.
struct BitGrid {
  Point origin{0, 0};
  double cell = 1;
  int columns = 0, rows = 0;
  std::vector<std::uint8_t> bits;  // row by row, 1 = set

  BitGrid() = default;
  BitGrid(Point origin_, double cell_, int columns_, int rows_)
      : origin(origin_),
        cell(cell_),
        columns(columns_),
        rows(rows_),
        bits(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {}
  bool inside(int i, int j) const { return i >= 0 && j >= 0 && i < columns && j < rows; }
  std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(i);
  }
  bool get(int i, int j) const { return inside(i, j) && bits[at(i, j)] != 0; }
  void set(int i, int j, bool value) { bits[at(i, j)] = value ? 1 : 0; }
  Point centre(int i, int j) const { return origin + cell * Point(i + 0.5, j + 0.5); }
  std::size_t count() const;
};

/// Which cells a region sets. A cell on the boundary follows the rule, exactly:
enum class CellRule {
  centre,   // its centre lies in the closed region
  inside,   // the whole closed cell lies in the closed region
  touches,  // its open square meets the region's interior
};
/// O(cells + edges + boundary cells).
BitGrid rasterise(const Region& region, const Point& origin, double cell, int columns, int rows, CellRule rule);

/// The set cells as a region with exact boundaries: corners are lattice points, every hole is a hole, cells that
/// share only a corner are apart (free space is 4-connected, walls 8-connected). O(cells).
Region trace(const BitGrid& grid);

/// Fewer corners, never more free space: corners are dropped only where that cuts free space off, each dropped
/// corner stays within `tolerance` of the new boundary, and rings never cross. tolerance 0 drops collinear
/// corners only. O(n log n) for usual data.
Region simplify_inward(const Region& region, double tolerance);

}  // namespace oxturn
