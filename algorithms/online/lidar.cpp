#include "algorithms/online/lidar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "base/math.hpp"
#include "base/text.hpp"
#include "maps/formats.hpp"

namespace oxturn {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();

void check_lidar(const Lidar& lidar) {
  if (lidar.rays < 1) throw std::invalid_argument(fmt::format("lidar.rays is {}, expected at least 1", lidar.rays));
  if (!(lidar.range > 0) || !std::isfinite(lidar.range))
    throw std::invalid_argument(fmt::format("lidar.range is {}, expected metres above 0", to_decimal(lidar.range)));
  if (!(lidar.noise >= 0) || !std::isfinite(lidar.noise))
    throw std::invalid_argument(
        fmt::format("lidar.noise is {}, expected metres of at least 0", to_decimal(lidar.noise)));
}

}  // namespace

std::vector<Point> ray_directions(int rays) {
  std::vector<Point> all;
  all.reserve(static_cast<std::size_t>(rays));
  for (int k = 0; k < rays; ++k) {
    const double angle = 2 * kPi * k / rays;
    all.emplace_back(math::cos(angle), math::sin(angle));
  }
  return all;
}

LidarSimulator::LidarSimulator(const Region& free, const Lidar& lidar) : lidar_(lidar) {
  check_lidar(lidar);
  direction_ = ray_directions(lidar.rays);
  for_each_edge(free, [&](const Point& a, const Point& b) {
    if (a != b) edges_.push_back({a, b});
  });
  grid_ = UniformGrid(edges_.size(), [&](std::size_t i) { return std::array{edges_[i].a, edges_[i].b}; });
}

/// From cell to cell. A vertex that two edges share is on the same (rounded) side of the ray for both, so no ray passes
/// between them.
double LidarSimulator::cast(const Point& eye, const Point& direction) const {
  double best = lidar_.range;
  bool met = false;
  int i = grid_.column(eye.x()), j = grid_.row(eye.y());
  const double cell = grid_.cell();
  const auto first_border = [&](double at, double low, double d, int index) {
    return d == 0 ? kNothing : (low + cell * (index + (d > 0 ? 1 : 0)) - at) / d;
  };
  double next_x = first_border(eye.x(), grid_.low().x(), direction.x(), i);
  double next_y = first_border(eye.y(), grid_.low().y(), direction.y(), j);
  const double step_x = direction.x() == 0 ? kNothing : cell / std::abs(direction.x());
  const double step_y = direction.y() == 0 ? kNothing : cell / std::abs(direction.y());
  while (i >= 0 && j >= 0 && i < grid_.columns() && j < grid_.rows()) {
    const std::size_t c = grid_.index(i, j);
    for (const std::uint32_t e : grid_.items(c)) {
      const EdgeIndex::Edge& edge = edges_[e];
      const Point a = edge.a - eye, b = edge.b - eye;
      const double left = cross(direction, a), right = cross(direction, b);
      if ((left > 0) == (right > 0)) continue;
      // Where ab meets the ray's line: between its ends, whatever the rounding.
      const double t = lerp(a, b, left / (left - right)).dot(direction);
      if (t >= 0 && t <= best) {
        best = t;
        met = true;
      }
    }
    const double leave = std::min(next_x, next_y);  // the cell
    if (leave > best + 1e-6 * cell) break;
    if (next_x <= next_y) {
      i += direction.x() > 0 ? 1 : -1;
      next_x += step_x;
    } else {
      j += direction.y() > 0 ? 1 : -1;
      next_y += step_y;
    }
  }
  return met ? best : kNothing;
}

Scan LidarSimulator::scan(const Point& eye, Rng& rng) const {
  Scan scan{eye, lidar_, {}};
  scan.reading.reserve(direction_.size());
  for (const Point& direction : direction_) {
    double reading = grid_.empty() ? kNothing : cast(eye, direction);
    if (lidar_.noise > 0 && reading < kNothing)
      reading = std::clamp(reading + lidar_.noise * rng.normal(), 0.0, lidar_.range);
    scan.reading.push_back(reading);
  }
  return scan;
}

}  // namespace oxturn
