#include "algorithms/smoothing/bezier.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "algorithms/smoothing/golden_section.hpp"
#include "algorithms/smoothing/quadrature.hpp"
#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kSamples = 64;   // of a curve, for its greatest curvature
constexpr double kRefined = 0.7;       // of the greatest sample: peaks above that are refined
constexpr double kSharp = 0.3;         // radians between two samples: their mean curvature counts too
constexpr double kLengthError = 1e-8;  // of the length
constexpr int kMostHalvings = 20;
constexpr std::size_t kSearchSamples = 32;  // of a quintic, while its handles are searched
constexpr int kHandles = 32;                // that are tried first

std::vector<Point> derivative(const std::vector<Point>& points) {
  std::vector<Point> result;
  const auto degree = static_cast<double>(points.size() - 1);
  for (std::size_t i = 1; i < points.size(); ++i) result.push_back(degree * (points[i] - points[i - 1]));
  return result;
}

/// Horner's scheme in Bernstein form.
Point value(const std::vector<Point>& points, double t) {
  if (points.empty()) return {0, 0};
  const std::size_t degree = points.size() - 1;
  if (degree == 0) return points.front();
  const double u = 1 - t;
  double power = 1, choose = 1;
  Point sum = u * points.front();
  for (std::size_t i = 1; i < degree; ++i) {
    power *= t;
    choose *= static_cast<double>(degree - i + 1) / static_cast<double>(i);
    sum = u * (sum + power * choose * points[i]);
  }
  return sum + power * t * points.back();
}

double curvature_of(const Point& velocity, const Point& acceleration) {
  const double speed = velocity.norm();
  return speed > 0 ? cross(velocity, acceleration) / (speed * speed * speed) : std::numeric_limits<double>::infinity();
}

/// Between two samples, whose velocities these are, the curve may turn round almost on the spot: then so much per metre
/// of the chord, else 0.
double mean_curvature(const Point& from, const Point& to, double chord) {
  const double dot = from.dot(to), area = std::abs(cross(from, to));
  if (dot > 0 && area < kSharp * dot) return 0;
  return chord > 0 ? math::atan2(area, dot) / chord : std::numeric_limits<double>::infinity();
}

/// The greatest curvature of the quintics between two poses, by the length of their handles. Their first and last three
/// control points lie on lines, so few terms of the Bernstein polynomials remain.
class QuinticFamily {
 public:
  QuinticFamily(const Pose& from, const Pose& to)
      : chord_(to.at - from.at), first_(direction(from)), last_(direction(to)) {
    for (std::size_t i = 0; i <= kSearchSamples; ++i) {
      const double t = static_cast<double>(i) / kSearchSamples, u = 1 - t;
      terms_[i] = {u * u * u * (u + 4 * t), 6 * u * u * t * t, t * t * t * (t + 4 * u), 3 * u * u * t, 3 * u * t * t};
    }
  }
  double largest_curvature(double handle) const {
    const Point a = handle * first_, b = handle * last_, middle = chord_ - 2 * (a + b);
    double largest = 0;
    Point before = 5 * a;
    for (const Terms& t : terms_) {
      const Point velocity = 5 * (t.first * a + t.middle * middle + t.last * b);
      const double chord = (before + velocity).norm() / (2 * kSearchSamples);  // almost
      largest = std::max(largest, mean_curvature(before, velocity, chord));
      before = velocity;
      const Point acceleration = 20 * (t.rise * (middle - a) + t.fall * (b - middle));
      largest = std::max(largest, std::abs(curvature_of(velocity, acceleration)));
    }
    return largest;
  }

 private:
  struct Terms {
    double first, middle, last;  // of the velocity
    double rise, fall;           // of the acceleration
  };
  Point chord_, first_, last_;
  std::array<Terms, kSearchSamples + 1> terms_{};
};

/// Halves the interval until that makes no difference.
template <class Function>
double refined_integral(const Function& f, double a, double b, double whole, double error, int halvings) {
  const double middle = (a + b) / 2, left = integral(f, a, middle), right = integral(f, middle, b);
  if (halvings == 0 || !(std::abs(left + right - whole) > error)) return left + right;
  return refined_integral(f, a, middle, left, error / 2, halvings - 1) +
         refined_integral(f, middle, b, right, error / 2, halvings - 1);
}

}  // namespace

Point position_at(const Bezier& curve, double t) { return value(curve.points, t); }

Point velocity_at(const Bezier& curve, double t) { return value(derivative(curve.points), t); }

double curvature_at(const Bezier& curve, double t) {
  const std::vector<Point> velocity = derivative(curve.points);
  return curvature_of(value(velocity, t), value(derivative(velocity), t));
}

double largest_curvature(const Bezier& curve) {
  const std::vector<Point> velocity = derivative(curve.points), acceleration = derivative(velocity);
  const auto bend = [&](double t) { return std::abs(curvature_of(value(velocity, t), value(acceleration, t))); };
  std::array<double, kSamples + 1> samples{};
  for (std::size_t i = 0; i <= kSamples; ++i) samples[i] = bend(static_cast<double>(i) / kSamples);
  double largest = *std::ranges::max_element(samples);
  for (std::size_t i = 0; i < kSamples; ++i) {
    const double a = static_cast<double>(i) / kSamples, b = static_cast<double>(i + 1) / kSamples;
    const double chord = distance(value(curve.points, a), value(curve.points, b));
    largest = std::max(largest, mean_curvature(value(velocity, a), value(velocity, b), chord));
  }
  const double refined = kRefined * largest;
  if (!std::isfinite(largest)) return largest;
  for (std::size_t i = 0; i <= kSamples; ++i) {
    const double before = i > 0 ? samples[i - 1] : 0, after = i < kSamples ? samples[i + 1] : 0;
    if (samples[i] < refined || samples[i] < before || samples[i] < after) continue;
    const double low = i > 0 ? static_cast<double>(i - 1) / kSamples : 0;
    const double high = i < kSamples ? static_cast<double>(i + 1) / kSamples : 1;
    const double peak = golden_section([&](double t) { return -bend(t); }, low, high, 1e-4 / kSamples);
    largest = std::max(largest, bend(peak));
  }
  return largest;
}

double length(const Bezier& curve) {
  const std::vector<Point> velocity = derivative(curve.points);
  const auto speed = [&](double t) { return value(velocity, t).norm(); };
  const double whole = integral(speed, 0, 1);
  return refined_integral(speed, 0, 1, whole, kLengthError * whole, kMostHalvings);
}

Bezier cubic_connection(const Pose& from, const Pose& to, double handle) {
  return {{from.at, ahead(from, handle).at, ahead(to, -handle).at, to.at}};
}

Bezier quintic_connection(const Pose& from, const Pose& to, double radius) {
  const QuinticFamily family(from, to);
  const double d = distance(from.at, to.at);
  const double least = std::max(d / 8, 1e-3 * radius), most = d + 4 * radius;
  const auto handle = [&](double k) { return least * math::pow(most / least, k / kHandles); };
  const auto bend = [&](double k) { return family.largest_curvature(handle(k)); };
  int best = 0;
  double least_bend = std::numeric_limits<double>::infinity();
  for (int k = 0; k <= kHandles; ++k)
    if (const double b = bend(k); b < least_bend) best = k, least_bend = b;
  const double h = handle(golden_section(bend, std::max(0, best - 1), std::min(kHandles, best + 1), 1e-3));
  return {{from.at, ahead(from, h).at, ahead(from, 2 * h).at, ahead(to, -2 * h).at, ahead(to, -h).at, to.at}};
}

}  // namespace oxturn
