#include "algorithms/smoothing/smooth_curve.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kNearest = 0.05;  // chord errors; samples nearer to each other than that are left out

double heading_of(const Point& v) { return math::atan2(v.y(), v.x()); }

Pose first_pose(const Clothoid& piece) { return piece.from; }
Pose last_pose(const Clothoid& piece) { return end_of(piece); }
/// Along the first control point that differs from the end.
Pose end_pose(const std::vector<Point>& points, const Point& end, bool forwards) {
  const std::size_t n = points.size();
  for (std::size_t i = 1; i < n; ++i)
    if (const Point step = points[forwards ? i : n - 1 - i] - end; step != Point(0, 0))
      return {end, heading_of(forwards ? step : Point(-step))};
  return {end, 0};
}
Pose first_pose(const Bezier& piece) { return end_pose(piece.points, piece.points.front(), true); }
Pose last_pose(const Bezier& piece) { return end_pose(piece.points, piece.points.back(), false); }

double metres(const Clothoid& piece) { return piece.length; }
double metres(const Bezier& piece) { return length(piece); }

double bend(const Clothoid& piece) {
  return std::max(std::abs(piece.curvature), std::abs(piece.curvature + piece.sharpness * piece.length));
}
double bend(const Bezier& piece) { return largest_curvature(piece); }

bool all_finite(const Clothoid& piece) {
  return finite(piece.from.at) && std::isfinite(piece.from.heading) && std::isfinite(piece.curvature) &&
         std::isfinite(piece.sharpness) && std::isfinite(piece.length);
}
bool all_finite(const Bezier& piece) {
  return std::ranges::all_of(piece.points, [](const Point& p) { return finite(p); });
}

/// So many chords leave the piece by `error` at most: length^2 curvature / 8.
double chords(const Clothoid& piece, double error) { return piece.length * std::sqrt(bend(piece) / (8 * error)); }
double chords(const Bezier& piece, double error) {
  double second = 0;  // differences of the control points, which bound the second derivative
  for (std::size_t i = 2; i < piece.points.size(); ++i)
    second = std::max(second, (piece.points[i] - 2 * piece.points[i - 1] + piece.points[i - 2]).norm());
  const auto degree = static_cast<double>(piece.points.size() - 1);
  return std::sqrt(degree * (degree - 1) * second / (8 * error));
}

Point position(const Clothoid& piece, double t) { return pose_at(piece, t * piece.length).at; }
Point position(const Bezier& piece, double t) { return position_at(piece, t); }

}  // namespace

SmoothCurve smooth_curve(const Curve& curve) {
  SmoothCurve result{curve.from, curve.to, {}};
  Pose at = curve.from;
  for (const CurvePiece& piece : curve.pieces) {
    if (piece.gear == Gear::reverse) throw std::invalid_argument("a smooth curve is driven forwards only");
    const double sense = piece.steering == Steering::left ? 1 : piece.steering == Steering::right ? -1 : 0;
    if (piece.length > 0) result.pieces.emplace_back(Clothoid{at, sense / curve.radius, 0, piece.length});
    at = after(at, piece, curve.radius);
  }
  return result;
}

double length(const SmoothCurve& curve) {
  double sum = 0;
  for (const auto& piece : curve.pieces) sum += std::visit([](const auto& p) { return metres(p); }, piece);
  return sum;
}

double largest_curvature(const SmoothCurve& curve) {
  double largest = 0;
  for (const auto& piece : curve.pieces)
    largest = std::max(largest, std::visit([](const auto& p) { return bend(p); }, piece));
  return largest;
}

bool finite(const SmoothCurve& curve) {
  return finite(curve.from.at) && finite(curve.to.at) && std::ranges::all_of(curve.pieces, [](const auto& piece) {
           return std::visit([](const auto& p) { return all_finite(p); }, piece);
         });
}

JointErrors joint_errors(const SmoothCurve& curve) {
  JointErrors errors;
  const auto compare = [&](const Pose& a, const Pose& b) {
    errors.position = std::max(errors.position, distance(a.at, b.at));
    errors.heading = std::max(errors.heading, std::abs(std::remainder(a.heading - b.heading, 2 * kPi)));
  };
  Pose at = curve.from;
  for (const auto& piece : curve.pieces) {
    compare(at, std::visit([](const auto& p) { return first_pose(p); }, piece));
    at = std::visit([](const auto& p) { return last_pose(p); }, piece);
  }
  compare(at, curve.to);
  return errors;
}

Polyline sampled(const SmoothCurve& curve, double chord_error) {
  const double nearest = kNearest * chord_error, error = (1 - kNearest) * chord_error;
  Polyline points{curve.from.at};
  const auto add = [&](const auto& piece) {
    const double parts = std::max(1.0, std::ceil(chords(piece, error)));
    for (double k = 1; k <= parts; ++k)
      if (const Point p = position(piece, k / parts); distance(points.back(), p) > nearest) points.push_back(p);
  };
  for (const auto& piece : curve.pieces) std::visit(add, piece);
  while (points.size() > 1 && distance(points.back(), curve.to.at) <= nearest) points.pop_back();
  if (points.back() != curve.to.at || points.size() == 1) points.push_back(curve.to.at);
  return points;
}

Polyline evenly_sampled(const Polyline& line, double step) {
  const double whole = length(line);
  if (line.size() < 2 || !(whole > 0)) return line;
  const double parts = std::ceil(whole / step);
  Polyline result{line.front()};
  double before = 0;  // the length up to the edge's begin
  std::size_t edge = 1;
  for (double k = 1; k < parts; ++k) {
    const double at = whole * k / parts;
    double along = distance(line[edge - 1], line[edge]);
    while (edge + 1 < line.size() && before + along < at) {
      before += along, ++edge;
      along = distance(line[edge - 1], line[edge]);
    }
    result.push_back(along > 0 ? lerp(line[edge - 1], line[edge], std::clamp((at - before) / along, 0.0, 1.0))
                               : line[edge]);
  }
  result.push_back(line.back());
  return result;
}

}  // namespace oxturn
