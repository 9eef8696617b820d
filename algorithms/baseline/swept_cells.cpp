#include "algorithms/baseline/swept_cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace oxturn {
namespace {

struct Span {
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

/// Where the line at height y is within `reach` of the segment ab: one span, for the capsule is convex.
Span across(const Point& a, const Point& b, double reach, double y) {
  Span span;
  for (const Point& end : {a, b}) {
    const double up = y - end.y(), half = reach * reach - up * up;
    if (half < 0) continue;
    span.add(end.x() - std::sqrt(half));
    span.add(end.x() + std::sqrt(half));
  }
  if (a == b) return span;
  const Point side = reach * perpendicular(b - a).normalized();
  for (const Point& shift : {side, Point(-side)}) {
    const Point p = a + shift, q = b + shift;
    if (p.y() == q.y() || (p.y() < y) == (q.y() < y)) continue;
    span.add(lerp(p, q, (y - p.y()) / (q.y() - p.y())).x());
  }
  return span;
}

}  // namespace

SweptCells::SweptCells(const Point& start, double tool_width)
    : cell_(tool_width / 8), reach_(tool_width / 2), origin_(start) {}

void SweptCells::sweep(const Point& a, const Point& b) {
  const Point p = (a - origin_) / cell_, q = (b - origin_) / cell_;
  const double reach = reach_ / cell_;
  const auto first = static_cast<std::int64_t>(std::ceil(std::min(p.y(), q.y()) - reach));
  const auto last = static_cast<std::int64_t>(std::floor(std::max(p.y(), q.y()) + reach));
  for (std::int64_t j = first; j <= last; ++j) {
    const Span span = across(p, q, reach, static_cast<double>(j));
    if (span.low > span.high) continue;
    const auto left = static_cast<std::int64_t>(std::ceil(span.low));
    const auto right = static_cast<std::int64_t>(std::floor(span.high));
    for (std::int64_t block = left >> 6; left <= right && block <= right >> 6; ++block) {
      std::uint64_t mask = ~std::uint64_t{0};
      if (block == left >> 6) mask &= ~std::uint64_t{0} << (left & 63);
      if (block == right >> 6) mask &= ~std::uint64_t{0} >> (63 - (right & 63));
      std::uint64_t& word = words_[static_cast<std::uint64_t>(j) << 32 | static_cast<std::uint32_t>(block)];
      count_ += static_cast<std::uint64_t>(std::popcount(mask & ~word));
      word |= mask;
    }
  }
}

}  // namespace oxturn
