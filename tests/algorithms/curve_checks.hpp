// Oracles for smooth curves that look at sampled points alone.
#pragma once

#include <algorithm>
#include <cmath>

#include "algorithms/smoothing/curve.hpp"
#include "base/random.hpp"

namespace oxturn {

/// The greatest curvature of the circles through three consecutive points.
inline double sampled_curvature(const Polyline& line) {
  double largest = 0;
  for (std::size_t i = 2; i < line.size(); ++i) {
    const Point a = line[i - 1] - line[i - 2], b = line[i] - line[i - 1], c = line[i] - line[i - 2];
    largest = std::max(largest, 2 * std::abs(cross(a, b)) / (a.norm() * b.norm() * c.norm()));
  }
  return largest;
}

inline double heading_between(const Point& a, const Point& b) { return std::atan2(b.y() - a.y(), b.x() - a.x()); }

/// The angle between the first chord and the heading of `from`, or between the last one and that of `to`.
inline double end_kink(const Polyline& line, const Pose& from, const Pose& to) {
  const double first = heading_between(line.front(), line[1]) - from.heading;
  const double last = heading_between(line[line.size() - 2], line.back()) - to.heading;
  return std::max(std::abs(std::remainder(first, 2 * kPi)), std::abs(std::remainder(last, 2 * kPi)));
}

/// Of any radius, anywhere; distances up to 40 radii, many of them small; headings random, aligned or opposite.
struct RandomConnection {
  explicit RandomConnection(Rng& rng) {
    radius = std::exp(rng.between(-2.0, 3.0));
    const double far =
        rng.chance(0.3) ? std::exp(rng.between(-14.0, 3.7)) : rng.between(0.0, rng.chance(0.5) ? 6.0 : 40.0);
    const double d = rng.chance(0.01) ? 0 : radius * far, theta = rng.between(-kPi, kPi);
    const auto heading = [&] {
      return rng.chance(0.2) ? theta + kPi / 2 * rng.between(-2, 2) : rng.between(-9.0, 9.0);
    };
    from = {{rng.between(-50.0, 50.0), rng.between(-50.0, 50.0)}, heading()};
    to = {from.at + d * direction({{0, 0}, theta}), heading()};
  }
  double radius;
  Pose from, to;
};

}  // namespace oxturn
