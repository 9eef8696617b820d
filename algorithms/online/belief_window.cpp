// The window of cells that a belief keeps, and how it grows.
#include <algorithm>
#include <cmath>

#include "algorithms/online/belief.hpp"

namespace oxturn {
namespace {

constexpr std::int64_t kMostCells = std::int64_t{1} << 26;

std::int64_t floor_to(std::int64_t v, std::int64_t step) {
  const std::int64_t rest = v % step;
  return v - (rest < 0 ? rest + step : rest);
}

}  // namespace

Belief::Bounds Belief::Bounds::aligned(std::int64_t step) const {
  return {floor_to(i0, step), floor_to(j0, step), floor_to(i1 + step - 1, step), floor_to(j1 + step - 1, step)};
}

/// An eighth more on the sides that grow, so that growing is rare.
Belief::Bounds Belief::with_spare(const Bounds& wanted) const {
  const std::int64_t spare_i = columns_ / 8, spare_j = rows_ / 8;
  return {wanted.i0 < window_.i0 ? wanted.i0 - spare_i : window_.i0,
          wanted.j0 < window_.j0 ? wanted.j0 - spare_j : window_.j0,
          wanted.i1 > window_.i1 ? wanted.i1 + spare_i : window_.i1,
          wanted.j1 > window_.j1 ? wanted.j1 + spare_j : window_.j1};
}

/// Makes the window contain the box. Cells become twice as coarse each time it would have too many.
void Belief::grow(const Point& low, const Point& high) {
  const auto index = [this](double v, double origin) {
    return static_cast<std::int64_t>(std::floor((v - origin) / cell_));
  };
  Bounds bounds{index(low.x(), lattice_.x()) - 2, index(low.y(), lattice_.y()) - 2, index(high.x(), lattice_.x()) + 3,
                index(high.y(), lattice_.y()) + 3};
  const bool first = columns_ == 0;
  if (!first) {
    if (window_.contains(bounds)) return;
    bounds = with_spare(bounds);
  }
  bounds = bounds.aligned(kBlock);
  int halvings = 0;
  while ((bounds.columns() >> halvings) * (bounds.rows() >> halvings) > kMostCells) ++halvings;
  if (halvings > 0) bounds = bounds.aligned(std::int64_t{kBlock} << halvings);

  const auto columns = static_cast<int>(bounds.columns() >> halvings),
             rows = static_cast<int>(bounds.rows() >> halvings);
  const std::size_t cells = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  std::vector<std::uint8_t> mark(cells, 0);
  std::vector<std::int8_t> weight(noisy() ? cells : 0, 0);
  if (halvings == 0)
    copy_to(bounds, mark, weight);
  else if (!first)
    merge_to(bounds, 1 << halvings, mark, weight);
  if (halvings > 0 && !first) ++lost_;  // coarser cells reach less far: what was planned must be checked again
  block_mark_.assign(cells / kBlock, 0);
  mark_ = std::move(mark);
  weight_ = std::move(weight);
  cell_ *= 1 << halvings;
  window_ = {bounds.i0 >> halvings, bounds.j0 >> halvings, bounds.i1 >> halvings, bounds.j1 >> halvings};
  columns_ = columns;
  rows_ = rows;
  low_ = lattice_ + cell_ * Point(static_cast<double>(window_.i0), static_cast<double>(window_.j0));
}

/// Copies the window's cells to where they lie within `bounds`.
void Belief::copy_to(const Bounds& bounds, std::vector<std::uint8_t>& mark, std::vector<std::int8_t>& weight) const {
  for (int j = 0; j < rows_; ++j) {
    const std::int64_t to = (j + window_.j0 - bounds.j0) * bounds.columns() + window_.i0 - bounds.i0;
    const auto from = static_cast<std::ptrdiff_t>(at(0, j));
    std::copy_n(mark_.begin() + from, columns_, mark.begin() + to);
    if (!weight.empty()) std::copy_n(weight_.begin() + from, columns_, weight.begin() + to);
  }
}

/// The same, with `block` x `block` cells to a coarser cell.
void Belief::merge_to(const Bounds& bounds, int block, std::vector<std::uint8_t>& mark,
                      std::vector<std::int8_t>& weight) const {
  std::size_t to = 0;
  for (std::int64_t j = bounds.j0; j < bounds.j1; j += block)
    for (std::int64_t i = bounds.i0; i < bounds.i1; i += block, ++to) {
      const CellState state = merged(i, j, block);
      mark[to] = state.mark;
      if (!weight.empty()) weight[to] = state.weight;
    }
}

/// A coarse cell is as certain as the least certain of its cells, and has a wall if one of them has. i and j: of its
/// first cell, on the lattice.
Belief::CellState Belief::merged(std::int64_t i, std::int64_t j, int block) const {
  std::uint8_t all = kFar | kNear, any = 0;
  int least = kMost;
  for (std::int64_t y = j; y < j + block; ++y)
    for (std::int64_t x = i; x < i + block; ++x) {
      if (!window_.contains(x, y))
        return {static_cast<std::uint8_t>(any & (kHit | kWall)), static_cast<std::int8_t>(std::min(least, 0))};
      const std::size_t from = at(static_cast<int>(x - window_.i0), static_cast<int>(y - window_.j0));
      std::uint8_t mark = mark_[from];
      if ((mark & kNear) != 0) mark |= kFar;
      all &= mark;
      any |= mark;
      if (noisy()) least = std::min<int>(least, weight_[from]);
    }
  return {static_cast<std::uint8_t>(all | (any & (kHit | kWall))), static_cast<std::int8_t>(least)};
}

}  // namespace oxturn
