/// What a robot remembers to have covered: small cells around its start, as many as it has come by.
///
///   SweptCells swept(start, tool_width);
///   swept.sweep(a, b);
///   double square_metres = swept.area();
///
/// Sweeping O(rows of cells that the tool crosses); a bit for each cell.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "geometry/point.hpp"

namespace oxturn {

class SweptCells {
 public:
  /// Cells of an eighth of the tool's width.
  SweptCells(const Point& start, double tool_width);
  /// A disc of the tool's width moves from a to b.
  void sweep(const Point& a, const Point& b);
  /// Square metres of the cells whose centres have been under the tool.
  double area() const { return static_cast<double>(count_) * cell_ * cell_; }

 private:
  void sweep_row(std::int64_t row, std::int64_t left, std::int64_t right);

  double cell_, reach_;
  Point origin_;
  std::unordered_map<std::uint64_t, std::uint64_t> words_;  // 64 cells of a row each; looked up, never listed
  std::uint64_t count_ = 0;
};

}  // namespace oxturn
