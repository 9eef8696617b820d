/// Small tools of the geodesic field: convex polygons of a few vertices, and directions that satisfy a linear equation.
/// Private to geometry, not installed.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "base/math.hpp"
#include "geometry/point.hpp"

namespace oxturn {

enum class KeptSide { left, right };

/// A triangle clipped by up to four half-planes, counter-clockwise. Allocates nothing.
class Facet {
 public:
  Facet(const Point& a, const Point& b, const Point& c) : size_(3) {
    vertex_[0] = a;
    vertex_[1] = b;
    vertex_[2] = c;
  }
  /// Keeps what is on one side of the line through p along the unit vector d, or within `slack` of the line, so that no
  /// vertex on it is lost by rounding.
  void clip(const Point& p, const Point& d, KeptSide kept, double slack) {
    const int side = kept == KeptSide::left ? 1 : -1;
    std::array<Point, 12> out;
    std::size_t n = 0;
    for (std::size_t i = 0; i < size_; ++i) {
      const Point &a = vertex_[i], &b = next(i);
      const double sa = side * cross(d, a - p), sb = side * cross(d, b - p);
      if (n + 2 > out.size()) break;
      if (sa >= -slack) out[n++] = a;
      if ((sa > slack && sb < -slack) || (sa < -slack && sb > slack)) out[n++] = lerp(a, b, sa / (sa - sb));
    }
    size_ = std::min<std::size_t>(n, vertex_.size());
    std::copy_n(out.begin(), size_, vertex_.begin());
  }
  /// The two halves of a triangle, divided at the midpoint of its longest edge.
  std::pair<Facet, Facet> halves() const {
    std::size_t k = 0;
    const auto length = [&](std::size_t i) { return distance(vertex_[i], next(i)); };
    for (std::size_t i = 1; i < 3; ++i)
      if (length(i) > length(k)) k = i;
    const Point &a = vertex_[k], &b = vertex_[(k + 1) % 3], &c = vertex_[(k + 2) % 3], middle = (a + b) / 2;
    return {Facet(a, middle, c), Facet(middle, b, c)};
  }
  bool empty() const { return size_ < 3; }
  std::span<const Point> vertices() const& { return {vertex_.data(), size_}; }
  void vertices() const&& = delete;  // would outlive the facet
  /// The vertex after vertex i.
  const Point& next(std::size_t i) const { return vertex_[i + 1 < size_ ? i + 1 : 0]; }
  /// Is x inside, or outside by at most `slack`?
  bool contains(const Point& x, double slack) const {
    for (std::size_t i = 0; i < size_; ++i) {
      const Point edge = next(i) - vertex_[i];
      if (cross(edge, x - vertex_[i]) < -slack * edge.norm()) return false;
    }
    return true;
  }
  /// The mean of the vertices.
  Point middle() const {
    Point sum(0, 0);
    for (const Point& p : vertices()) sum += p;
    return sum / static_cast<double>(size_);
  }

 private:
  std::array<Point, 9> vertex_;
  std::size_t size_;
};

/// Calls f(angle) for each of the at most two unit vectors e with e . a = b.
template <class F>
void for_each_angle(const Point& a, double b, F f) {
  const double n = a.norm();
  if (!(n > 0) || std::abs(b) > n * (1 + 1e-13)) return;  // rounding may lose a double root
  const double middle = math::atan2(a.y(), a.x()), half = math::acos(std::clamp(b / n, -1.0, 1.0));
  f(middle + half);
  f(middle - half);
}

/// Sorts the breaks, angles or other parameters of a curve, and calls f(begin, end) for every longest sequence of
/// intervals between them for which good(middle of the interval) is true.
template <class Good, class F>
void for_each_run(std::vector<double>& breaks, Good good, F f) {
  constexpr double kLeast = 1e-15;  // shorter intervals are rounding
  std::sort(breaks.begin(), breaks.end());
  std::optional<double> begin;
  double end = 0;
  for (std::size_t i = 1; i < breaks.size(); ++i) {
    if (breaks[i] - breaks[i - 1] < kLeast) continue;
    if (good((breaks[i - 1] + breaks[i]) / 2)) {
      begin = begin.value_or(breaks[i - 1]);
      end = breaks[i];
    } else if (begin) {
      f(*std::exchange(begin, std::nullopt), end);
    }
  }
  if (begin) f(*begin, end);
}

/// The equal angle in [-pi, pi].
inline double wrapped(double angle) { return std::remainder(angle, 2 * kPi); }
inline Point direction_of(double angle) { return {math::cos(angle), math::sin(angle)}; }

}  // namespace oxturn
