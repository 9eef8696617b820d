/// A value for each cell of a lattice of unknown extent: a window that grows where it is written to.
///
///   CellMap<int> distance;
///   distance[{-3, 7}] = 5;
///   distance.get({100, 100});     // 0: never written
///
/// Reading O(1); writing O(1) amortised over the cells of the window.
#pragma once

#include <algorithm>
#include <vector>

#include "algorithms/lattice/grid_graph.hpp"

namespace oxturn {

template <class T>
class CellMap {
 public:
  /// T{} for a cell that was never written.
  T get(const Cell& c) const { return inside(c) ? values_[at(c)] : T{}; }
  /// Grows the window if necessary, which invalidates earlier references.
  T& operator[](const Cell& c) {
    if (!inside(c)) [[unlikely]]
      grow(c);
    return values_[at(c)];
  }

 private:
  bool inside(const Cell& c) const {
    return static_cast<unsigned>(c.i - low_.i) < static_cast<unsigned>(columns_) &&
           static_cast<unsigned>(c.j - low_.j) < static_cast<unsigned>(rows_);
  }
  std::size_t at(const Cell& c) const {
    return static_cast<std::size_t>(c.j - low_.j) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(c.i - low_.i);
  }
  // By half of its size, towards `c` only: all copies together are a few times the final window.
  void grow(const Cell& c) {
    Cell low = low_, high{low_.i + columns_, low_.j + rows_};
    if (values_.empty()) low = high = c;
    const int more_i = std::max(8, columns_ / 2), more_j = std::max(8, rows_ / 2);
    if (c.i < low.i || values_.empty()) low.i = std::min(c.i, low.i - more_i);
    if (c.j < low.j || values_.empty()) low.j = std::min(c.j, low.j - more_j);
    if (c.i >= high.i) high.i = std::max(c.i + 1, high.i + more_i);
    if (c.j >= high.j) high.j = std::max(c.j + 1, high.j + more_j);
    CellMap larger;
    larger.low_ = low;
    larger.columns_ = high.i - low.i;
    larger.rows_ = high.j - low.j;
    larger.values_.resize(static_cast<std::size_t>(larger.columns_) * static_cast<std::size_t>(larger.rows_));
    for (int j = 0; j < rows_; ++j) {
      const auto row = values_.begin() + static_cast<std::ptrdiff_t>(j) * columns_;
      std::copy(row, row + columns_,
                larger.values_.begin() + static_cast<std::ptrdiff_t>(larger.at({low_.i, low_.j + j})));
    }
    *this = std::move(larger);
  }

  Cell low_;
  int columns_ = 0, rows_ = 0;
  std::vector<T> values_;
};

}  // namespace oxturn
