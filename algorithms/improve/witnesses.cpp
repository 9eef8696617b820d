#include "algorithms/improve/witnesses.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/raster.hpp"

namespace oxturn {
namespace {

constexpr double kTurn = 0.739;  // radians: no multiple of a usual angle between walls

/// Calls f(row, low, high) for the points of capsule x that do not lie in capsule y, in intervals.
template <class F>
void for_each_difference(const Witnesses::Capsule& x, const Witnesses::Capsule& y, F f) {
  const int shift = x.first - y.first;
  for (int k = 0; k < x.rows; ++k) {
    const auto i = static_cast<std::size_t>(k), j = static_cast<std::size_t>(k + shift);
    const int low = x.low[i], high = x.high[i];
    const bool meets = k + shift >= 0 && k + shift < y.rows && y.low[j] < high && y.high[j] > low;
    if (!meets) {
      if (low < high) f(x.first + k, low, high);
      continue;
    }
    if (low < y.low[j]) f(x.first + k, low, y.low[j]);
    if (y.high[j] < high) f(x.first + k, y.high[j], high);
  }
}

const Witnesses::Capsule& at(std::span<const Witnesses::Capsule> capsules, std::size_t i) {
  static const Witnesses::Capsule none;
  return i < capsules.size() ? capsules[i] : none;
}

}  // namespace

Witnesses::Witnesses(const Region& target, double cell, double radius) : cell_(cell), radius_(radius / cell) {
  const Region turned = transformed(target, -kTurn, Point(0, 0));
  const Box box = bounding_box(turned);
  if (box.empty()) return;
  origin_ = box.low;
  columns_ = static_cast<int>(box.size().x() / cell) + 1;
  rows_ = static_cast<int>(box.size().y() / cell) + 1;
  BitGrid grid = rasterise(turned, origin_, cell, columns_, rows_, CellRule::centre);
  points_ = uncovered_ = static_cast<long>(grid.count());
  counts_ = std::move(grid.bits);
  for (std::uint8_t& c : counts_) c = c != 0 ? 0 : kOutside;
}

/// In units of cells, such that the point of column i and row j has the coordinates (i, j).
Point Witnesses::in_raster(const Point& p) const {
  static const double c = std::cos(kTurn), s = std::sin(kTurn);
  const Point turned(c * p.x() + s * p.y(), c * p.y() - s * p.x());
  return (turned - origin_) / cell_ - Point(0.5, 0.5);
}

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
  for (int k = 0; k < out.rows; ++k) {
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

void Witnesses::apply(const Capsule& old, const Capsule& next) {
  for_each_difference(next, old, [&](int r, int low, int high) {
    std::uint8_t* c = row(r);
    int found = 0;
    for (int i = low; i < high; ++i) {
      found += c[i] == 0;
      c[i] = static_cast<std::uint8_t>(c[i] + 1);
    }
    uncovered_ -= found;
  });
  for_each_difference(old, next, [&](int r, int low, int high) {
    std::uint8_t* c = row(r);
    int lost = 0;
    for (int i = low; i < high; ++i) {
      c[i] = static_cast<std::uint8_t>(c[i] - 1);
      lost += c[i] == 0;
    }
    uncovered_ += lost;
  });
}

long Witnesses::gain(std::span<const Capsule> olds, std::span<const Capsule> news) const {
  long sum = 0;
  for (std::size_t i = 0; i < news.size(); ++i)
    for_each_difference(news[i], at(olds, i), [&](int r, int low, int high) {
      const std::uint8_t* c = row(r);
      int found = 0;
      for (int k = low; k < high; ++k) found += c[k] == 0;
      sum += found;
    });
  return sum;
}

long Witnesses::exchange(std::span<const Capsule> olds, std::span<const Capsule> news) {
  const long before = uncovered_;
  for (std::size_t i = 0; i < std::max(olds.size(), news.size()); ++i) apply(at(olds, i), at(news, i));
  return uncovered_ - before;
}

}  // namespace oxturn
