// Lengths of Dubins curves: shortest forward paths between two poses with a least turning radius (Dubins 1957), by the
// closed forms of Shkel and Lumelsky (2001). For tests and benchmarks of tours with directed costs.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/point.hpp"

namespace oxturn {

struct DirectedPoint {
  Point at;
  double heading = 0;
};

inline double full_turn(double angle) {
  const double turn = 2 * std::numbers::pi;
  const double a = angle - turn * std::floor(angle / turn);
  return a > turn - 1e-9 ? 0 : a;  // rounding must not add a circle
}

/// The least of the words LSL, RSR, LSR, RSL, RLR and LRL.
inline double dubins_length(const DirectedPoint& from, const DirectedPoint& to, double radius) {
  const Point line = (to.at - from.at) / radius;
  const double d = line.norm(), theta = d > 0 ? std::atan2(line.y(), line.x()) : 0;
  const double a = full_turn(from.heading - theta), b = full_turn(to.heading - theta);
  const double sa = std::sin(a), sb = std::sin(b), ca = std::cos(a), cb = std::cos(b), c = std::cos(a - b);
  double best = std::numeric_limits<double>::infinity();
  const auto offer = [&](double first, double middle, double last) {
    best = std::min(best, full_turn(first) + middle + full_turn(last));
  };
  if (const double p = 2 + d * d - 2 * c + 2 * d * (sa - sb); p >= 0) {
    const double t = std::atan2(cb - ca, d + sa - sb);
    offer(t - a, std::sqrt(p), b - t);
  }
  if (const double p = 2 + d * d - 2 * c + 2 * d * (sb - sa); p >= 0) {
    const double t = std::atan2(ca - cb, d - sa + sb);
    offer(a - t, std::sqrt(p), t - b);
  }
  if (const double p = -2 + d * d + 2 * c + 2 * d * (sa + sb); p >= 0) {
    const double s = std::sqrt(p), t = std::atan2(-ca - cb, d + sa + sb) - std::atan2(-2, s);
    offer(t - a, s, t - b);
  }
  if (const double p = -2 + d * d + 2 * c - 2 * d * (sa + sb); p >= 0) {
    const double s = std::sqrt(p), t = std::atan2(ca + cb, d - sa - sb) - std::atan2(2, s);
    offer(a - t, s, b - t);
  }
  if (const double p = (6 - d * d + 2 * c + 2 * d * (sa - sb)) / 8; std::abs(p) <= 1) {
    const double s = full_turn(-std::acos(p)), t = full_turn(a - std::atan2(ca - cb, d - sa + sb) + s / 2);
    offer(t, s, a - b - t + s);
  }
  if (const double p = (6 - d * d + 2 * c + 2 * d * (sb - sa)) / 8; std::abs(p) <= 1) {
    const double s = full_turn(-std::acos(p)), t = full_turn(-a + std::atan2(-ca + cb, d + sa - sb) + s / 2);
    offer(t, s, b - a - t + s);
  }
  return radius * best;
}

}  // namespace oxturn
