#include "metrics/smooth_path.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/point_count.hpp"

namespace oxturn {
namespace {

constexpr double kStraight = 1e-7;  // radians; less is rounding

}  // namespace

SmoothPath::SmoothPath(std::span<const Leg> legs, double h)
    : h_(h), s_{0}, points_{Point(0, 0)}, integral_{Wide{}}, bends_{0} {
  const std::size_t most = 1 + point_count(legs);
  for (auto* of_vertices : {&s_, &bends_}) of_vertices->reserve(most);
  points_.reserve(most);
  integral_.reserve(most);
  Point heading(0, 0);
  for (const Leg& leg : legs) {
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      const Point step = leg.points[i] - leg.points[i - 1];
      const double length = step.norm();
      if (!(length > 0)) continue;
      const Point unit = step / length;
      if (s_.size() > 1 && (std::abs(cross(heading, unit)) > kStraight || heading.dot(unit) < 0))
        bends_.push_back(s_.back());
      heading = unit;
      const Point& p = points_.back();
      const Wide& sum = integral_.back();
      const long double l = length;
      integral_.push_back({sum.x + l * (p.x() + 0.5L * step.x()), sum.y + l * (p.y() + 0.5L * step.y())});
      points_.push_back(p + step);
      s_.push_back(s_.back() + length);
    }
  }
  bends_.push_back(length());
}

SmoothPath::Sample SmoothPath::sample(double s, std::size_t& cursor) const {
  if (s <= 0) return {Point(0, 0), Wide{}};
  const std::size_t last = s_.size() - 1;
  if (s >= s_[last]) {
    const long double d = s - s_[last];
    return {points_[last], {integral_[last].x + d * points_[last].x(), integral_[last].y + d * points_[last].y()}};
  }
  while (s_[cursor + 1] <= s) ++cursor;
  while (s_[cursor] > s) --cursor;
  const double d = s - s_[cursor];
  const Point& from = points_[cursor];
  const Point step = d / (s_[cursor + 1] - s_[cursor]) * (points_[cursor + 1] - from);
  const Wide& sum = integral_[cursor];
  const long double l = d;
  return {from + step, {sum.x + l * (from.x() + 0.5L * step.x()), sum.y + l * (from.y() + 0.5L * step.y())}};
}

/// max(0, s), convolved with the kernel.
double SmoothPath::ramp(double s) const {
  const double wide = 2 * h_, rest = wide - std::abs(s);
  if (rest <= 0) return std::max(0.0, s);
  return std::max(0.0, s) + rest * rest * rest / (6 * wide * wide);
}

double SmoothPath::ramp_rate(double s) const {
  const double wide = 2 * h_, rest = wide - std::abs(s);
  if (rest <= 0) return s > 0 ? 1 : 0;
  const double part = rest * rest / (2 * wide * wide);
  return s > 0 ? 1 - part : part;
}

SmoothPath::State SmoothPath::at(double s) {
  const double wide = 2 * h_, scale = 1 / (wide * wide);
  const Sample before = sample(s - wide, cursors_[0]), here = sample(s, cursors_[1]),
               after = sample(s + wide, cursors_[2]);
  State state;
  state.first = Point(static_cast<double>(after.integral.x - 2 * here.integral.x + before.integral.x),
                      static_cast<double>(after.integral.y - 2 * here.integral.y + before.integral.y)) *
                scale;
  state.second = (after.point - 2 * here.point + before.point) * scale;
  state.progress = ramp(s) - ramp(s - length());
  state.rate = ramp_rate(s) - ramp_rate(s - length());
  return state;
}

}  // namespace oxturn
