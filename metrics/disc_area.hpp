/// Area of the intersection of a disc and a polygon, edge by edge.
///
///   DiscArea common(centre, radius);
///   for_each_edge(ring, [&](const Point& a, const Point& b) { common.add(a, b); });
///   common.area();
///
/// Each edge adds the signed area of the disc's part in the triangle of its centre and the edge: positive if a, b run
/// counter-clockwise. Rings may be clipped, overlap or run backwards (which counts negative). Exact but for rounding.
/// O(1) an edge, without trigonometry: the angles of all sectors are added as a product of complex numbers.
#pragma once

#include <cmath>

#include "base/math.hpp"
#include "geometry/region.hpp"

namespace oxturn {

class DiscArea {
 public:
  DiscArea(const Point& centre, double radius) : centre_(centre), radius_(radius) {}

  void add(const Point& from, const Point& to) {
    const Point a = from - centre_, b = to - centre_, d = b - a;
    const double aa = d.squaredNorm(), half = a.dot(d),
                 square = half * half - aa * (a.squaredNorm() - radius_ * radius_);
    if (!(aa > 0)) return;
    if (square <= 0) return turn(a, b);
    const double root = std::sqrt(square);
    if (-half - root >= aa || -half + root <= 0) return turn(a, b);
    const double enters = (-half - root) / aa, leaves = (-half + root) / aa;
    const Point p = enters > 0 ? Point(a + enters * d) : a, q = leaves < 1 ? Point(a + leaves * d) : b;
    triangles_ += cross(p, q) / 2;
    if (enters > 0) turn(a, p);
    if (leaves < 1) turn(q, b);
  }

  double area() const { return triangles_ + radius_ * radius_ / 2 * (2 * kPi * turns_ + math::atan2(sine_, cosine_)); }

 private:
  /// Adds the angle from a to b: (-pi, pi], 0 if either is the centre.
  void turn(const Point& a, const Point& b) {
    const double c = a.dot(b), s = cross(a, b);
    const double x = cosine_ * c - sine_ * s, y = sine_ * c + cosine_ * s + 0.0;  // no -0: half a turn is pi
    if (x == 0 && y == 0) return;
    if (s > 0 || (s == 0 && c < 0)) {
      if (sine_ >= 0 && (y < 0 || (y == 0 && x > 0 && cosine_ < 0))) ++turns_;
    } else if (s < 0 && sine_ < 0 && (y > 0 || (y == 0 && x < 0))) {
      --turns_;
    }
    cosine_ = x, sine_ = y;
    if (const double size = std::abs(x) + std::abs(y); size > kLarge || size < 1 / kLarge)
      cosine_ /= size, sine_ /= size;
  }

  static constexpr double kLarge = 1e60;  // the product must neither overflow nor vanish
  Point centre_;
  double radius_, triangles_ = 0;
  // The sum of the angles: whole turns, and the direction of (cosine_, sine_) within (-pi, pi].
  double turns_ = 0, cosine_ = 1, sine_ = 0;
};

/// The ring's part on the left of the directed line from `a` to `b` (Sutherland and Hodgman 1974). Parts of a ring that
/// is not convex stay joined by edges that cancel in every area.
Ring clipped_left(const Ring& ring, const Point& a, const Point& b);

}  // namespace oxturn
