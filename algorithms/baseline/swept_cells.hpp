// What a robot remembers to have swept: small cells about its start, as many as it has come by.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "geometry/point.hpp"

namespace oxturn {

class SweptCells {
 public:
  /// Cells of an eighth of the tool's width.
  SweptCells(const Point& start, double tool_width);
  /// A disc as wide as the tool moves from a to b. O(rows of cells that it crosses).
  void sweep(const Point& a, const Point& b);
  /// Square metres of the cells whose centres have been under the tool.
  double area() const { return static_cast<double>(count_) * cell_ * cell_; }

 private:
  double cell_, reach_;
  Point origin_;
  std::unordered_map<std::uint64_t, std::uint64_t> words_;  // 64 cells of a row each; looked up, never listed
  std::uint64_t count_ = 0;
};

}  // namespace oxturn
