// Points in a uniform grid, to be visited by increasing distance and taken out again.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <queue>
#include <vector>

#include "geometry/point.hpp"

namespace oxturn {

class PointGrid {
 public:
  explicit PointGrid(const std::vector<Point>& points) : points_(points), removed_(points.size(), false) {
    for (const Point& p : points_) box_.add(p);
    if (points_.empty()) box_.add({0, 0});
    const double side = std::max({box_.size().x(), box_.size().y(), 1e-9});
    const double area = std::max(box_.size().x(), side * 1e-3) * std::max(box_.size().y(), side * 1e-3);
    cell_ = std::sqrt(area / (static_cast<double>(points_.size()) / 2 + 1));
    columns_ = static_cast<int>(box_.size().x() / cell_) + 1;
    rows_ = static_cast<int>(box_.size().y() / cell_) + 1;
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (std::size_t i = 0; i < points_.size(); ++i)
      cells_[cell_of(points_[i])].push_back(static_cast<std::uint32_t>(i));
    left_ = points_.size();
  }

  void remove(std::size_t i) {
    if (removed_[i]) return;
    removed_[i] = true;
    --left_;
    auto& cell = cells_[cell_of(points_[i])];
    cell.erase(std::find(cell.begin(), cell.end(), static_cast<std::uint32_t>(i)));
  }
  std::size_t remaining() const { return left_; }

  /// Calls f(index, distance) for the points left, nearest first (equal: lower index first), until f says false.
  template <class F>
  void visit(const Point& p, F f) const {
    using Item = std::pair<double, std::uint32_t>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> found;
    const int ci = column(p.x()), cj = row(p.y());
    // Points outside the box are clamped to it: the ring's distance then counts from the clamped place.
    const Point inner(std::clamp(p.x(), box_.low.x(), box_.high.x()), std::clamp(p.y(), box_.low.y(), box_.high.y()));
    const double gap = distance(p, inner);
    std::size_t seen = 0;
    const int rings = std::max(std::max(ci, columns_ - 1 - ci), std::max(cj, rows_ - 1 - cj));
    for (int ring = 0; ring <= rings && seen < left_; ++ring) {
      for (int j = std::max(0, cj - ring); j <= std::min(rows_ - 1, cj + ring); ++j) {
        const bool whole = j == cj - ring || j == cj + ring;
        const int step = whole || ring == 0 ? 1 : 2 * ring;
        for (int i = ci - ring; i <= ci + ring; i += step) {
          if (i < 0 || i >= columns_) continue;
          for (const std::uint32_t k : cells_[index(i, j)]) {
            found.push({distance(p, points_[k]), k});
            ++seen;
          }
        }
      }
      // Everything nearer than `certain` has been met: cells beyond this ring are at least so far away.
      const double certain = ring == rings ? 1e300 : std::max(ring * cell_ - gap, 0.0);
      while (!found.empty() && (found.top().first <= certain || seen == left_)) {
        const Item item = found.top();
        found.pop();
        if (!f(static_cast<std::size_t>(item.second), item.first)) return;
      }
    }
  }

 private:
  int column(double x) const { return std::clamp(static_cast<int>((x - box_.low.x()) / cell_), 0, columns_ - 1); }
  int row(double y) const { return std::clamp(static_cast<int>((y - box_.low.y()) / cell_), 0, rows_ - 1); }
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  }
  std::size_t cell_of(const Point& p) const { return index(column(p.x()), row(p.y())); }

  std::vector<Point> points_;
  std::vector<bool> removed_;
  Box box_;
  double cell_ = 1;
  int columns_ = 1, rows_ = 1;
  std::vector<std::vector<std::uint32_t>> cells_;
  std::size_t left_ = 0;
};

}  // namespace oxturn
