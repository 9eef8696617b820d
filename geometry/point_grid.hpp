/// Points in a uniform grid, visited in the order of their distance; points can be removed.
///
///   PointGrid grid(points);
///   grid.remove(3);
///   grid.visit(p, [&](std::size_t i, double distance) { return ++count < 10; });   // the ten nearest
///
/// Build O(n). A visit O(k log k) for the k points in the cells that it looks at, which are those nearer than the last
/// point visited.
#pragma once

#include <algorithm>
#include <cstdint>
#include <queue>
#include <vector>

#include "geometry/cell_ring.hpp"
#include "geometry/uniform_grid.hpp"

namespace oxturn {

class PointGrid {
 public:
  explicit PointGrid(const std::vector<Point>& points)
      : points_(points), removed_(points.size(), false), remaining_(points.size()) {
    Box box;
    for (const Point& p : points_) box.add(p);
    // UniformGrid has two cells an item; searches for the nearest are faster with two points a cell.
    grid_ = UniformGrid(box, points_.empty() ? 0 : points_.size() / 4 + 1, 0);
    grid_.fill(points_.size(), [this](std::size_t i, auto enter) { enter(cell_of(points_[i])); });
    remaining_in_.assign(static_cast<std::size_t>(grid_.columns()) * static_cast<std::size_t>(grid_.rows()), 0);
    for (const Point& p : points_) ++remaining_in_[cell_of(p)];
  }

  void remove(std::size_t i) {
    if (removed_[i]) return;
    removed_[i] = true;
    --remaining_;
    --remaining_in_[cell_of(points_[i])];
  }
  /// How many points have not been removed.
  std::size_t remaining() const { return remaining_; }

  /// Calls f(index, distance) for the remaining points, nearest first (equally near: lower index first), until f
  /// returns false.
  template <class F>
  void visit(const Point& p, F f) const {
    if (remaining_ == 0) return;
    using Item = std::pair<double, std::uint32_t>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> found;
    const int ci = grid_.column(p.x()), cj = grid_.row(p.y()), columns = grid_.columns(), rows = grid_.rows();
    // For a point outside the box the rings are around the nearest point of the box.
    const double outside = distance(p, p.cwiseMax(grid_.low()).cwiseMin(grid_.high()));
    std::size_t seen = 0;
    const int rings = std::max({ci, columns - 1 - ci, cj, rows - 1 - cj});
    for (int ring = 0; ring <= rings && seen < remaining_; ++ring) {
      for_each_in_ring(ci, cj, ring, columns, rows, [&](int i, int j) {
        const std::size_t cell = grid_.index(i, j);
        if (remaining_in_[cell] == 0) return;
        for (const std::uint32_t k : grid_.items(cell)) {
          if (removed_[k]) continue;
          found.push({distance(p, points_[k]), k});
          ++seen;
        }
      });
      // Cells beyond this ring are at least so far away.
      const double certain = ring == rings ? 1e300 : std::max(ring * grid_.cell() - outside, 0.0);
      while (!found.empty() && (found.top().first <= certain || seen == remaining_)) {
        const Item item = found.top();
        found.pop();
        if (!f(static_cast<std::size_t>(item.second), item.first)) return;
      }
    }
  }

 private:
  std::size_t cell_of(const Point& p) const { return grid_.index(grid_.column(p.x()), grid_.row(p.y())); }

  std::vector<Point> points_;
  std::vector<bool> removed_;
  std::size_t remaining_;
  UniformGrid grid_;
  std::vector<std::uint32_t> remaining_in_;  // by cell
};

}  // namespace oxturn
