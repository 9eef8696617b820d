#include "geometry/raster.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/centre_crossings.hpp"

namespace oxturn {
namespace {

int clamped(double x, int low, int high) { return static_cast<int>(std::clamp<double>(x, low, high)); }

/// Sets the cells whose centre lies in the closed region: by the parity of the edges to the left of the centre, and
/// those whose centre is exactly on an edge.
void mark_centres(const Region& region, BitGrid& grid) {
  std::vector<std::size_t> on_edge;
  for_each_centre_crossing(
      region, grid, [&](int i, int j) { grid.bits[grid.at(i, j)] ^= 1; },
      [&](int i, int j) { on_edge.push_back(grid.at(i, j)); });
  for (int j = 0; j < grid.rows; ++j)
    for (int i = 1; i < grid.columns; ++i) grid.bits[grid.at(i, j)] ^= grid.bits[grid.at(i - 1, j)];
  for (const std::size_t c : on_edge) grid.bits[c] = 1;
}

/// Calls f(cell) for every cell whose open square an edge meets. Coordinates within 1e-9 cells of a grid line count as
/// on it, so that the edges of a region traced on this grid meet none.
template <class F>
void for_each_cut_cell(const Region& region, const BitGrid& grid, F f) {
  const auto snapped = [](double u) {
    const double near = std::round(u);
    return std::abs(u - near) < 1e-9 ? near : u;
  };
  const auto cut = [&](const Point& from, const Point& to) {
    const Point u = (from - grid.origin) / grid.cell, v = (to - grid.origin) / grid.cell;
    const Point a(snapped(u.x()), snapped(u.y())), b(snapped(v.x()), snapped(v.y()));
    const double bottom = std::min(a.y(), b.y()), top = std::max(a.y(), b.y());
    if (bottom == top && bottom == std::floor(bottom)) return;  // runs along a grid line
    const int first = clamped(std::floor(bottom), 0, grid.rows);
    const int last = clamped(bottom == top ? std::floor(top) : std::ceil(top) - 1, -1, grid.rows - 1);
    for (int j = first; j <= last; ++j) {
      const auto x_at = [&](double y) {
        if (bottom == top) return a.x();
        return snapped(a.x() + std::clamp((y - a.y()) / (b.y() - a.y()), 0.0, 1.0) * (b.x() - a.x()));
      };
      double left = x_at(std::max<double>(j, bottom)), right = x_at(std::min<double>(j + 1, top));
      if (bottom == top) {
        left = a.x();
        right = b.x();
      }
      if (left > right) std::swap(left, right);
      if (left == right && left == std::floor(left)) continue;  // runs along a grid line or meets it in a point
      const int from_column = clamped(std::floor(left), 0, grid.columns);
      const int to_column = clamped(left == right ? std::floor(right) : std::ceil(right) - 1, -1, grid.columns - 1);
      for (int i = from_column; i <= to_column; ++i) f(grid.at(i, j));
    }
  };
  for_each_edge(region, cut);
}

}  // namespace

std::size_t BitGrid::count() const {
  return static_cast<std::size_t>(std::count_if(bits.begin(), bits.end(), [](std::uint8_t b) { return b != 0; }));
}

BitGrid rasterise(const Region& region, const Point& origin, double cell, int columns, int rows, CellRule rule) {
  BitGrid grid(origin, cell, columns, rows);
  mark_centres(region, grid);
  // A cell that no edge meets lies inside or outside as a whole, as its centre does; any other has points of both.
  if (rule != CellRule::centre)
    for_each_cut_cell(region, grid, [&](std::size_t c) { grid.bits[c] = rule == CellRule::touches ? 1 : 0; });
  return grid;
}

Region squares_around(const std::vector<Polyline>& segments, double reach, double cell) {
  Box box;
  for (const Polyline& segment : segments)
    for (const Point& p : segment) box.add(p);
  box.grow(reach + cell);
  const Point size = box.size() / cell;
  BitGrid grid(box.low, cell, static_cast<int>(std::ceil(size.x())), static_cast<int>(std::ceil(size.y())));
  const int around = static_cast<int>(std::ceil(reach / cell + 0.5));  // samples are up to a cell apart
  for (const Polyline& segment : segments) {
    const double n = std::max(1.0, std::ceil(distance(segment[0], segment[1]) / cell));
    for (double k = 0; k <= n; ++k) {
      const Point at = (lerp(segment[0], segment[1], k / n) - grid.origin) / cell;
      const int i = static_cast<int>(at.x()), j = static_cast<int>(at.y());
      for (int y = std::max(0, j - around); y <= std::min(grid.rows - 1, j + around); ++y)
        for (int x = std::max(0, i - around); x <= std::min(grid.columns - 1, i + around); ++x) grid.set(x, y, true);
    }
  }
  return trace(grid);
}

}  // namespace oxturn
