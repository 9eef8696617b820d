#include "algorithms/baseline/swept_cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace oxturn {
namespace {

struct Interval {
  double low = 1, high = 0;  // empty
  void add(double x) {
    if (low > high) {
      low = high = x;
      return;
    }
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

/// Where the line at height y is within `reach` of the segment ab: one interval, because the capsule is convex.
Interval across(const Point& a, const Point& b, double reach, double y) {
  Interval interval;
  for (const Point& end : {a, b}) {
    const double up = y - end.y(), half = reach * reach - up * up;
    if (half < 0) continue;
    interval.add(end.x() - std::sqrt(half));
    interval.add(end.x() + std::sqrt(half));
  }
  if (a == b) return interval;
  const Point side = reach * perpendicular(b - a).normalized();
  for (const Point& shift : {side, Point(-side)}) {
    const Point p = a + shift, q = b + shift;
    if (p.y() == q.y() || (p.y() < y) == (q.y() < y)) continue;
    interval.add(lerp(p, q, (y - p.y()) / (q.y() - p.y())).x());
  }
  return interval;
}

}  // namespace

SweptCells::SweptCells(const Point& start, double tool_width)
    : cell_(tool_width / 8), reach_(tool_width / 2), origin_(start) {}

void SweptCells::sweep(const Point& a, const Point& b) {
  const Point p = (a - origin_) / cell_, q = (b - origin_) / cell_;
  const double reach = reach_ / cell_;
  const auto first = static_cast<std::int64_t>(std::ceil(std::min(p.y(), q.y()) - reach));
  const auto last = static_cast<std::int64_t>(std::floor(std::max(p.y(), q.y()) + reach));
  for (std::int64_t row = first; row <= last; ++row) {
    const Interval interval = across(p, q, reach, static_cast<double>(row));
    if (interval.low > interval.high) continue;
    sweep_row(row, static_cast<std::int64_t>(std::ceil(interval.low)),
              static_cast<std::int64_t>(std::floor(interval.high)));
  }
}

/// Cells left to right of a row, a word of 64 cells at a time.
void SweptCells::sweep_row(std::int64_t row, std::int64_t left, std::int64_t right) {
  for (std::int64_t block = left >> 6; left <= right && block <= right >> 6; ++block) {
    std::uint64_t mask = ~std::uint64_t{0};
    if (block == left >> 6) mask &= ~std::uint64_t{0} << (left & 63);
    if (block == right >> 6) mask &= ~std::uint64_t{0} >> (63 - (right & 63));
    std::uint64_t& word = words_[static_cast<std::uint64_t>(row) << 32 | static_cast<std::uint32_t>(block)];
    count_ += static_cast<std::uint64_t>(std::popcount(mask & ~word));
    word |= mask;
  }
}

}  // namespace oxturn
