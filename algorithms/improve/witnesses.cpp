#include "algorithms/improve/witnesses.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kTurn = 0.739;  // radians: no multiple of a usual angle between walls

/// Calls f(row, low, high) for the points of capsule x that do not lie in capsule y, in intervals, until f returns
/// false.
template <class F>
void for_each_difference(const Witnesses::Capsule& x, const Witnesses::Capsule& y, F f) {
  const int shift = x.first - y.first;
  for (int k = 0; k < x.rows; ++k) {
    const auto i = static_cast<std::size_t>(k), j = static_cast<std::size_t>(k + shift);
    const int low = x.low[i], high = x.high[i];
    const bool meets = k + shift >= 0 && k + shift < y.rows && y.low[j] < high && y.high[j] > low;
    if (!meets) {
      if (low < high && !f(x.first + k, low, high)) return;
      continue;
    }
    if (low < y.low[j] && !f(x.first + k, low, y.low[j])) return;
    if (y.high[j] < high && !f(x.first + k, y.high[j], high)) return;
  }
}

// Eight counters in one word; each operation works on all of them, without carries from one to the next.
constexpr std::uint64_t kOnes = 0x0101010101010101, kHigh = 0x8080808080808080, kLow = 0x7f7f7f7f7f7f7f7f;

std::uint64_t load(const std::uint8_t* at) {
  std::uint64_t word = 0;
  std::memcpy(&word, at, sizeof word);
  return word;
}
/// The lowest n of eight counters, 0 < n.
std::uint64_t first_of(int n) { return n >= 8 ? ~std::uint64_t{0} : (std::uint64_t{1} << (8 * n)) - 1; }
std::uint64_t plus(std::uint64_t x, std::uint64_t y) { return ((x & kLow) + (y & kLow)) ^ ((x ^ y) & kHigh); }
/// How many of the counters under the mask are 0.
int zeros(std::uint64_t x, std::uint64_t mask) {
  const std::uint64_t high = ~(((x & kLow) + kLow) | x) & kHigh & mask;
  return static_cast<int>(((high >> 7) * kOnes) >> 56);
}

/// How many counters are 0; of those equal to 1, for value = 1.
int count(const std::uint8_t* from, int n, std::uint64_t value) {
  int found = 0;
  for (; n > 0; n -= 8, from += 8) found += zeros(load(from) ^ (value * kOnes), first_of(n));
  return found;
}
/// Adds `by`, 1 or 255, which is -1. How many were or are 0: those that became covered or uncovered.
int add_to(std::uint8_t* from, int n, std::uint64_t by) {
  int found = 0;
  for (; n > 0; n -= 8, from += 8) {
    const std::uint64_t mask = first_of(n), before = load(from), after = plus(before, by * kOnes & mask);
    std::memcpy(from, &after, sizeof after);
    found += zeros(by == 1 ? before : after, mask);
  }
  return found;
}

/// How many of the counters low to high - 1 of row r have the value and lie in no capsule.
int lost(const std::uint8_t* row, int r, int low, int high, std::span<const Witnesses::Capsule> capsules,
         std::uint64_t value) {
  for (std::size_t i = 0; i < capsules.size() && low < high; ++i) {
    const Witnesses::Capsule& c = capsules[i];
    if (r < c.first || r >= c.first + c.rows) continue;
    const int from = c.low[static_cast<std::size_t>(r - c.first)], to = c.high[static_cast<std::size_t>(r - c.first)];
    if (from >= to || to <= low || from >= high) continue;
    if (from <= low)
      low = to;
    else if (to >= high)
      high = from;
    else
      return lost(row, r, low, from, capsules.subspan(i + 1), value) +
             lost(row, r, to, high, capsules.subspan(i + 1), value);
  }
  return low < high ? count(row + low, high - low, value) : 0;
}

/// Calls f(row, low, high) for the points of both capsules, in intervals, until f returns false.
template <class F>
void for_each_common(const Witnesses::Capsule& x, const Witnesses::Capsule& y, F f) {
  const int end = std::min(x.first + x.rows, y.first + y.rows);
  for (int r = std::max(x.first, y.first); r < end; ++r) {
    const auto i = static_cast<std::size_t>(r - x.first), j = static_cast<std::size_t>(r - y.first);
    const int low = std::max(x.low[i], y.low[j]), high = std::min(x.high[i], y.high[j]);
    if (low < high && !f(r, low, high)) return;
  }
}

const Witnesses::Capsule& at(std::span<const Witnesses::Capsule> capsules, std::size_t i) {
  static const Witnesses::Capsule none;
  return i < capsules.size() ? capsules[i] : none;
}

}  // namespace

Region Witnesses::turned(const Region& region) { return transformed(region, -kTurn, Point(0, 0)); }

Point Witnesses::turned(const Point& p) {
  static const double c = math::cos(kTurn), s = math::sin(kTurn);
  return {c * p.x() + s * p.y(), c * p.y() - s * p.x()};
}

Witnesses::Witnesses(const Region& target, double cell, double radius)
    : Witnesses(turned(target), bounding_box(turned(target)), cell, radius) {}

Witnesses::Witnesses(const Region& turned_target, const Box& window, double cell, double radius)
    : cell_(cell), radius_(radius / cell) {
  if (window.empty()) return;
  origin_ = window.low;
  const int columns = static_cast<int>(window.size().x() / cell) + 1;
  const int rows = static_cast<int>(window.size().y() / cell) + 1;
  set_target(RasterRows(turned_target, origin_, cell, columns, rows), {0, 0, columns, rows});
}

Witnesses::Witnesses(const RasterRows& target, const Point& origin, const CellRange& part, double cell, double radius)
    : cell_(cell), radius_(radius / cell), origin_(origin + cell * Point(part.column, part.row)) {
  set_target(target, part);
}

void Witnesses::set_target(const RasterRows& target, const CellRange& part) {
  columns_ = part.end_column - part.column;
  rows_ = part.end_row - part.row;
  counts_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + sizeof(std::uint64_t),
                 kOutside);
  tile_columns_ = (columns_ - 1) / kTile + 1;
  tiles_.resize(static_cast<std::size_t>(tile_columns_) * static_cast<std::size_t>((rows_ - 1) / kTile + 1));
  for (int r = 0; r < rows_; ++r) {
    const auto runs = target.row(part.row + r);
    const auto first = std::ranges::upper_bound(runs, part.column, {}, &RasterRows::Run::high);
    for (auto run = first; run != runs.end() && run->low < part.end_column; ++run) {
      const int low = std::max(run->low, part.column) - part.column;
      const int high = std::min(run->high, part.end_column) - part.column;
      std::fill(row(r) + low, row(r) + high, std::uint8_t{0});
      points_ += high - low;
      for (int from = low; from < high;) {
        const int end = std::min(high, (from / kTile + 1) * kTile);
        tiles_[tile(r, from)] += end - from;
        from = end;
      }
    }
  }
  uncovered_ = points_;
}

/// In units of cells, such that the point of column i and row j has the coordinates (i, j).
Point Witnesses::in_raster(const Point& p) const { return (turned(p) - origin_) / cell_ - Point(0.5, 0.5); }

void Witnesses::capsule(const Point& a, const Point& b, Capsule& out) const {
  Point p = in_raster(a), q = in_raster(b);
  if (q.y() < p.y() || (q.y() == p.y() && q.x() < p.x())) std::swap(p, q);
  out.first = std::max(0, static_cast<int>(std::ceil(p.y() - radius_)));
  out.rows = std::max(0, std::min(rows_ - 1, static_cast<int>(std::floor(q.y() + radius_))) - out.first + 1);
  if (out.low.size() < static_cast<std::size_t>(out.rows)) {
    out.low.resize(static_cast<std::size_t>(out.rows));
    out.high.resize(static_cast<std::size_t>(out.rows));
  }
  // The leftmost point of a row belongs to the disc about that point of the edge whose leftmost or tangent point the
  // row meets. n: unit normal of the edge to the left; it is (-v, u) for the direction (u, v), v >= 0.
  const Point d = q - p;
  const double size = d.norm();
  const bool flat = d.y() <= 1e-6 * size;
  const float n = static_cast<float>(size > 0 ? d.x() / size * radius_ : 0);
  const float slope = static_cast<float>(flat ? 0 : 1 / d.y());
  // Of a flat edge, the leftmost and the rightmost end.
  const float s_least = flat && d.x() < 0 ? 1 : 0, s_most = flat ? s_least : 1;
  const float t_least = flat && d.x() > 0 ? 1 : 0, t_most = flat ? t_least : 1;
  const float px = static_cast<float>(p.x()), py = static_cast<float>(p.y()), dx = static_cast<float>(d.x()),
              dy = static_cast<float>(d.y()), r2 = static_cast<float>(radius_ * radius_),
              width = static_cast<float>(columns_);
  const float first = static_cast<float>(out.first) - py;
  std::int32_t *low = out.low.data(), *high = out.high.data();
  const int rows = out.rows;  // a copy: out.rows might be a part of what is written, and the loop be no vector code
  for (int k = 0; k < rows; ++k) {
    const float y = first + static_cast<float>(k);
    const float s = std::min(std::max((y - n) * slope, s_least), s_most);
    const float t = std::min(std::max((y + n) * slope, t_least), t_most);
    const float v = y - s * dy, u = y - t * dy;
    const float left = px + s * dx - std::sqrt(std::max(r2 - v * v, 0.0F));
    const float right = px + t * dx + std::sqrt(std::max(r2 - u * u, 0.0F));
    // Rounded up: conversion to int rounds towards 0, and neither is negative.
    const float from = std::min(std::max(left, 0.0F), width), to = std::min(std::max(right + 1, 0.0F), width);
    const auto whole = static_cast<std::int32_t>(from);
    low[k] = whole + (static_cast<float>(whole) < from ? 1 : 0);
    high[k] = static_cast<std::int32_t>(to);
  }
}

std::vector<Point> Witnesses::uncovered_points(std::size_t most) const {
  static const double c = math::cos(kTurn), s = math::sin(kTurn);
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i + sizeof(std::uint64_t) <= counts_.size(); i += sizeof(std::uint64_t)) {
    if (zeros(load(counts_.data() + i), ~std::uint64_t{0}) == 0) continue;
    std::size_t k = i;
    while (counts_[k] != 0) ++k;
    found.push_back(k);
  }
  std::vector<Point> points;
  const auto columns = static_cast<std::size_t>(columns_);
  for (std::size_t n = 0; n < found.size(); n += (found.size() - 1) / most + 1) {
    const Point cell(static_cast<double>(found[n] % columns), static_cast<double>(found[n] / columns));
    const Point p = origin_ + cell_ * (cell + Point(0.5, 0.5));
    points.emplace_back(c * p.x() - s * p.y(), c * p.y() + s * p.x());
  }
  return points;
}

void Witnesses::apply(const Capsule& old, const Capsule& next) {
  for_each_difference(next, old, [&](int r, int low, int high) {
    if (add_to(row(r) + low, high - low, 1) > 0) count_uncovered(r, low, high, 1, -1);
    return true;
  });
  for_each_difference(old, next, [&](int r, int low, int high) {
    if (add_to(row(r) + low, high - low, 255) > 0) count_uncovered(r, low, high, 0, 1);
    return true;
  });
}

/// In an interval some points became covered or uncovered: those whose counter is `value` now.
void Witnesses::count_uncovered(int r, int low, int high, std::uint64_t value, int sign) {
  while (low < high) {
    const int end = std::min(high, (low / kTile + 1) * kTile), found = count(row(r) + low, end - low, value);
    tiles_[tile(r, low)] += sign * found;
    uncovered_ += sign * found;
    low = end;
  }
}

/// Not less than the number of uncovered points in the capsules: those of all tiles that they meet.
long Witnesses::most_uncovered(std::span<const Capsule> capsules) const {
  long sum = 0;
  for (const Capsule& c : capsules) {
    for (int k = 0; k < c.rows && sum < uncovered_;) {
      const int r = c.first + k, end = std::min(c.rows, k + kTile - r % kTile);
      int low = columns_, high = 0;
      for (; k < end; ++k) {
        low = std::min(low, c.low[static_cast<std::size_t>(k)]);
        high = std::max(high, c.high[static_cast<std::size_t>(k)]);
      }
      if (low >= high) continue;
      for (std::size_t t = tile(r, low); t <= tile(r, high - 1); ++t) sum += tiles_[t];
    }
  }
  return std::min(sum, uncovered_);
}

bool Witnesses::may_change(std::span<const Capsule> removed, std::span<const Capsule> added, long most) const {
  const long gained = most_uncovered(added);  // at most
  if (-gained > most) return false;
  long change = 0;
  const auto lost_of = [&](std::uint64_t value) {
    return [this, &change, added, gained, most, value](int r, int low, int high) {
      change += lost(row(r), r, low, high, added, value);
      return change - gained <= most;
    };
  };
  for (std::size_t i = 0; i < removed.size(); ++i)
    for (std::size_t j = 0; j < i && change - gained <= most; ++j) for_each_common(removed[j], removed[i], lost_of(2));
  for (std::size_t i = 0; i < removed.size() && change - gained <= most; ++i)
    for_each_difference(removed[i], at(added, i), lost_of(1));
  if (change - gained > most) return false;
  for (std::size_t i = 0; i < added.size() && change > most; ++i)
    for_each_difference(added[i], at(removed, i), [&](int r, int low, int high) {
      change -= count(row(r) + low, high - low, 0);
      return change > most;
    });
  return change <= most;
}

long Witnesses::exchange(std::span<const Capsule> removed, std::span<const Capsule> added) {
  const long before = uncovered_;
  for (std::size_t i = 0; i < std::max(removed.size(), added.size()); ++i) apply(at(removed, i), at(added, i));
  return uncovered_ - before;
}

}  // namespace oxturn
