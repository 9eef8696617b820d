/// A uniform grid of square cells over a box, with the items that meet each cell.
///
///   const UniformGrid grid(segments.size(), [&](std::size_t i) { return std::array{segments[i].a, segments[i].b}; });
///   grid.visit_items(std::array{a, b}, reach, [&](std::uint32_t i) {
///     return near(segments[i], a, b);           // segment i may come within `reach`; true stops the visit
///   });
///
/// The items of all cells lie in one array, cell by cell. Cells are entered with a tolerance of kSlack cells: a query
/// finds every item that it meets in spite of rounding. What it finds are candidates, to be decided by exact
/// predicates.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/point.hpp"

namespace oxturn {

class UniformGrid {
 public:
  UniformGrid() = default;
  /// About two cells for each item; larger cells where items are long (`total_length` is the sum of their lengths), so
  /// that the number of cells and that of entries both stay O(items).
  UniformGrid(const Box& box, std::size_t items, double total_length) {
    if (items == 0 || box.empty()) return;
    low_ = box.low;
    high_ = box.high;
    const Point size = box.size();
    const double n = static_cast<double>(items);
    cell_ = std::max(
        {std::sqrt(size.x() * size.y() / (2 * n)), total_length / (4 * n), (size.x() + size.y()) / (2 * n), 1e-300});
    columns_ = static_cast<int>(size.x() / cell_) + 1;
    rows_ = static_cast<int>(size.y() / cell_) + 1;
  }

  /// The grid of n points, segments or convex polygons: shape(i) are the vertices of item i.
  template <class Shape>
  UniformGrid(std::size_t n, Shape shape) {
    Box box;
    double total = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto& vertices = shape(i);
      const std::size_t corners = vertices.size();
      for (const Point& p : vertices) box.add(p);
      for (std::size_t k = 0; k < corners && corners > 2; ++k)
        total += distance(vertices[k], vertices[(k + 1) % corners]) / 2;
      if (corners == 2) total += distance(vertices[0], vertices[1]);
    }
    *this = UniformGrid(box, n, total);
    fill(n, [&](std::size_t i, auto enter) { visit_cells(shape(i), 0, 1, enter); });
  }

  /// Puts item i into every cell c for which visit_item(i, enter) calls enter(c). Calls it twice for each item: first
  /// to count, then to store.
  template <class Visit>
  void fill(std::size_t items, Visit visit_item) {
    first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    for (std::size_t i = 0; i < items; ++i)
      visit_item(i, [&](std::size_t c) {
        ++first_[c + 1];
        return false;
      });
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    items_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < items; ++i)
      visit_item(i, [&](std::size_t c) {
        items_[next[c]++] = static_cast<std::uint32_t>(i);
        return false;
      });
  }

  bool empty() const { return columns_ == 0; }
  /// Side of a cell, metres.
  double cell() const { return cell_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  const Point& low() const { return low_; }
  const Point& high() const { return high_; }
  /// The column of x; outside the box, the nearest one.
  int column(double x) const { return clamped((x - low_.x()) / cell_, columns_); }
  int row(double y) const { return clamped((y - low_.y()) / cell_, rows_); }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }
  /// The items in a cell, in ascending order.
  std::span<const std::uint32_t> items(std::size_t cell) const {
    return {items_.data() + first_[cell], items_.data() + first_[cell + 1]};
  }
  /// Those in columns `from` to `to` of a row, cell by cell.
  std::span<const std::uint32_t> items(int from, int to, int row) const {
    return {items_.data() + first_[index(from, row)], items_.data() + first_[index(to, row) + 1]};
  }

  /// Calls f(item), row by row, for the items in every cell within `pad` of a point, a segment or a convex polygon,
  /// given by its vertices, and for those in some cells farther away; repeatedly for those in several cells. Stops when
  /// f returns true, and returns whether it did.
  template <class F>
  bool visit_items(std::span<const Point> vertices, double pad, F f) const {
    return visit_rows(vertices, pad, kFewCells, [&](int from, int to, int row) {
      for (const std::uint32_t item : items(from, to, row))
        if (f(item)) return true;
      return false;
    });
  }
  /// The same for f(cell).
  template <class F>
  bool visit(std::span<const Point> vertices, double pad, F f) const {
    return visit_cells(vertices, pad, kFewCells, f);
  }

 private:
  static constexpr double kSlack = 1e-7;          // cells: far above the rounding of (x - low) / cell
  static constexpr std::size_t kFewVertices = 4;  // those of most shapes
  static constexpr int kFewCells = 16;            // to choose those near a shape costs more than to look into all
  static int clamped(double v, int n) { return v > 0 ? static_cast<int>(std::min(v, static_cast<double>(n - 1))) : 0; }

  template <class F>
  bool visit_cells(std::span<const Point> vertices, double pad, int few, F f) const {
    return visit_rows(vertices, pad, few, [&](int from, int to, int row) {
      for (int i = from; i <= to; ++i)
        if (f(index(i, row))) return true;
      return false;
    });
  }
  /// Calls f(first column, last column, row) as visit() its f. Cells that are farther away than slightly are visited
  /// only where the shape's bounding box meets `few` cells at most.
  template <class F>
  bool visit_rows(std::span<const Point> vertices, double pad, int few, F f) const {
    if (empty()) return false;
    std::array<Point, kFewVertices> buffer;
    std::vector<Point> longer(vertices.size() > kFewVertices ? vertices.size() : 0);
    const std::span<Point> shape(longer.empty() ? buffer.data() : longer.data(), vertices.size());  // in cells
    const double reach = pad / cell_ + kSlack;
    double left = 1e300, right = -1e300, bottom = 1e300, top = -1e300;
    for (std::size_t i = 0; i < shape.size(); ++i) {
      shape[i] = (vertices[i] - low_) / cell_;
      left = std::min(left, shape[i].x());
      right = std::max(right, shape[i].x());
      bottom = std::min(bottom, shape[i].y());
      top = std::max(top, shape[i].y());
    }
    if (!(top + reach >= 0 && bottom - reach <= rows_ && right + reach >= 0 && left - reach <= columns_)) return false;
    const int first = clamped(left - reach, columns_), end = clamped(right + reach, columns_);
    const int low = clamped(bottom - reach, rows_), high = clamped(top + reach, rows_);
    const bool all = end - first < few && high - low < few && (end - first + 1) * (high - low + 1) <= few;
    for (int j = low; j <= high; ++j) {
      const auto [from, to] = all ? std::pair(first, end) : columns_near(shape, j, reach);
      if (from <= to && f(from, to, j)) return true;
    }
    return false;
  }
  /// The columns of row j within `reach` of a shape; all in cells.
  std::pair<int, int> columns_near(std::span<const Point> shape, int j, double reach) const {
    double left = 1e300, right = -1e300;
    const std::size_t edges = shape.size() == 2 ? 1 : shape.size();
    for (std::size_t i = 0; i < edges; ++i)
      widen(shape[i], shape[i + 1 < shape.size() ? i + 1 : 0], j - reach, j + 1 + reach, left, right);
    left -= reach;
    right += reach;
    if (!(left <= columns_ && right >= 0)) return {0, -1};
    return {clamped(left, columns_), clamped(right, columns_)};
  }
  /// Widens [left, right] by the columns of the part of pq between the heights v0 and v1; all in cells.
  static void widen(const Point& p, const Point& q, double v0, double v1, double& left, double& right) {
    if (std::max(p.y(), q.y()) < v0 || std::min(p.y(), q.y()) > v1) return;
    double s = 0, t = 1;
    const double dv = q.y() - p.y();
    if (dv != 0) {
      s = std::clamp((v0 - p.y()) / dv, 0.0, 1.0);
      t = std::clamp((v1 - p.y()) / dv, 0.0, 1.0);
    }
    for (const double at : {s, t}) {
      const double u = at == 1 ? q.x() : p.x() + at * (q.x() - p.x());
      left = std::min(left, u);
      right = std::max(right, u);
    }
  }

  Point low_{0, 0}, high_{0, 0};
  double cell_ = 1;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint32_t> first_, items_;  // items of cell c: items_[first_[c] .. first_[c + 1])
};

}  // namespace oxturn
