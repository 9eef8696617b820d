/// The cells whose centre lies in a region, as runs of each row: any part of a large raster is at hand without looking
/// at the region's edges again.
///
///   const RasterRows rows(region, origin, 0.01, columns, row_count);
///   for (const RasterRows::Run& run : rows.row(7)) ...       // cells run.low to run.high - 1, in their order
///
/// The same cells as rasterise(region, ..., CellRule::centre) sets.
/// Complexity  O(edges + c log c) time for c crossings of edges and rows, O(rows + c) memory; row(): O(1)
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

class RasterRows {
 public:
  struct Run {
    std::int32_t low, high;
  };
  RasterRows(const Region& region, const Point& origin, double cell, int columns, int rows);
  int columns() const { return columns_; }
  int rows() const { return static_cast<int>(first_.size()) - 1; }
  /// Runs that are disjoint and not empty, from left to right.
  std::span<const Run> row(int j) const {
    const auto at = static_cast<std::size_t>(j);
    return {runs_.data() + first_[at], first_[at + 1] - first_[at]};
  }

 private:
  int columns_;
  std::vector<Run> runs_;
  std::vector<std::size_t> first_;  // run of each row
};

}  // namespace oxturn
