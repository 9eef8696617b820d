// A convex polygon of a few corners, cut by half-planes; and directions that satisfy e . a = b. Private to geometry: not
// installed.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "geometry/point.hpp"

namespace oxturn {

/// A triangle, less up to four half-planes, counter-clockwise. No allocation.
class Facet {
 public:
  Facet(const Point& a, const Point& b, const Point& c) : size_(3) {
    corner_[0] = a;
    corner_[1] = b;
    corner_[2] = c;
  }
  /// Keeps what lies at the left of the line through p along the unit vector d (at the right, for side < 0), or within
  /// `slack` of it: corners on the line must not get lost by rounding.
  void keep(const Point& p, const Point& d, int side, double slack) {
    std::array<Point, 12> out;
    std::size_t n = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const Point &a = corner_[i], &b = corner_[i + 1 < size_ ? i + 1 : 0];
      const double sa = side * cross(d, a - p), sb = side * cross(d, b - p);
      if (n + 2 > out.size()) break;
      if (sa >= -slack) out[n++] = a;
      if ((sa > slack && sb < -slack) || (sa < -slack && sb > slack)) out[n++] = lerp(a, b, sa / (sa - sb));
    }
    size_ = std::min<std::size_t>(n, corner_.size());
    std::copy_n(out.begin(), size_, corner_.begin());
  }
  /// Of a triangle: cut in two across its longest edge.
  std::pair<Facet, Facet> halves() const {
    std::size_t k = 0;
    const auto length = [&](std::size_t i) { return distance(corner_[i], next(i)); };
    for (std::size_t i = 1; i < 3; ++i) {
      if (length(i) > length(k)) k = i;
    }
    const Point &a = corner_[k], &b = corner_[(k + 1) % 3], &c = corner_[(k + 2) % 3], middle = (a + b) / 2;
    return {Facet(a, middle, c), Facet(middle, b, c)};
  }
  bool empty() const { return size_ < 3; }
  std::span<const Point> corners() const { return {corner_.data(), size_}; }
  const Point& next(std::size_t i) const { return corner_[i + 1 < size_ ? i + 1 : 0]; }
  /// Holds x, or comes as near as `slack`?
  bool holds(const Point& x, double slack) const {
    for (std::size_t i = 0; i < size_; ++i) {
      const Point edge = next(i) - corner_[i];
      if (cross(edge, x - corner_[i]) < -slack * edge.norm()) return false;
    }
    return true;
  }
  Point middle() const {
    Point sum(0, 0);
    for (const Point& p : corners()) sum += p;
    return sum / static_cast<double>(size_);
  }

 private:
  std::array<Point, 9> corner_;
  std::size_t size_;
};

/// Calls f with each of the (at most two) angles of unit vectors e with e . a = b.
template <class F>
void for_each_angle(const Point& a, double b, F f) {
  const double n = a.norm();
  if (!(n > 0) || std::abs(b) > n * (1 + 1e-13)) return;
  const double middle = std::atan2(a.y(), a.x()), half = std::acos(std::clamp(b / n, -1.0, 1.0));
  f(middle + half);
  f(middle - half);
}

/// The angle, less whole turns, within half a turn of zero.
inline double turned(double angle) { return std::remainder(angle, 2 * kPi); }
inline Point direction_of(double angle) { return {std::cos(angle), std::sin(angle)}; }

}  // namespace oxturn
