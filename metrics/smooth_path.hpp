/// A path with rounded corners, as a robot drives it. Private to metrics/.
///
///   SmoothPath path(legs, 0.04);
///   const SmoothPath::State here = path.at(1.5);
///
///   ------------.                 the path; the curve leaves it 2 h before a vertex
///                `.
///                  |
///
/// Definition  With P(s) the path by arc length, extended by its first and last point, and K a box of half-width h
///             convolved with itself (a triangle of half-width 2 h):
///               C(s) = integral of P(s + u) K(u) du,   -2 h <= s <= L + 2 h
///             On straight parts C(s) = P(s). The curve begins and ends where the path does.
/// Method      The convolution is the second difference of an integral: with I the integral of P,
///               C'(s)  = (I(s + 2 h) - 2 I(s) + I(s - 2 h)) / 4 h^2
///               C''(s) = (P(s + 2 h) - 2 P(s) + P(s - 2 h)) / 4 h^2
///             Progress is the arc length, clamped to [0, L] and convolved in the same way.
/// Complexity  O(n); at(): O(1) if s moves little from call to call
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/path.hpp"

namespace oxturn {

class SmoothPath {
 public:
  /// Gaps between legs are closed by moving the later legs.
  SmoothPath(std::span<const Leg> legs, double h);

  double half_width() const { return h_; }
  double length() const { return s_.back(); }  // of the path, metres
  /// Arc lengths of the start, of the vertices at which the path changes its heading, and of the end, ascending.
  const std::vector<double>& bends() const { return bends_; }

  struct State {
    Point first{0, 0}, second{0, 0};  // derivatives of C by s
    double progress = 0;              // metres of the path
    double rate = 0;                  // its derivative by s
  };
  State at(double s);

 private:
  struct Wide {
    long double x = 0, y = 0;
  };
  /// Of one of the three arguments.
  struct Sample {
    Point point;
    Wide integral;
  };
  Sample sample(double s, std::size_t& cursor) const;
  double ramp(double s) const;
  double ramp_rate(double s) const;

  double h_;
  std::vector<double> s_;       // arc lengths of the vertices
  std::vector<Point> points_;   // relative to the first
  std::vector<Wide> integral_;  // of the points, from 0 to the vertex
  std::vector<double> bends_;
  std::array<std::size_t, 3> cursors_{};
};

}  // namespace oxturn
