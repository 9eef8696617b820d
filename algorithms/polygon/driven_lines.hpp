/// Lines in the cells of a grid without bounds, to find those near a box while more are added.
///
///   DrivenLines driven(32 * tool_width);
///   driven.add(line);
///   for (const Polyline& line : driven.near(box)) ...
///
/// Both cost O(log n) for each cell that a box meets, and near() the lines there.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "base/sorting.hpp"
#include "geometry/point.hpp"

namespace oxturn {

class DrivenLines {
 public:
  explicit DrivenLines(double cell) : cell_(cell) {}
  void add(const Polyline& line) {
    Box box;
    for (const Point& p : line) box.add(p);
    for_each_cell(box, [&](const Cell& cell) { in_cell_[cell].push_back(lines_.size()); });
    lines_.emplace_back(box, line);
  }
  /// Those whose boxes overlap, in the order in which they were added.
  std::vector<Polyline> near(const Box& box) const {
    std::vector<std::size_t> found;
    for_each_cell(box, [&](const Cell& cell) {
      if (const auto here = in_cell_.find(cell); here != in_cell_.end())
        found.insert(found.end(), here->second.begin(), here->second.end());
    });
    sort_unique(found);
    std::vector<Polyline> lines;
    for (const std::size_t k : found)
      if (lines_[k].first.overlaps(box)) lines.push_back(lines_[k].second);
    return lines;
  }

 private:
  using Cell = std::pair<std::int64_t, std::int64_t>;
  template <class F>
  void for_each_cell(const Box& box, F f) const {
    const auto number = [&](double at) { return static_cast<std::int64_t>(std::floor(at / cell_)); };
    for (std::int64_t j = number(box.low.y()); j <= number(box.high.y()); ++j)
      for (std::int64_t i = number(box.low.x()); i <= number(box.high.x()); ++i) f({i, j});
  }

  double cell_;
  std::vector<std::pair<Box, Polyline>> lines_;
  std::map<Cell, std::vector<std::size_t>> in_cell_;
};

}  // namespace oxturn
