/// Points and vectors in the plane, in metres, x to the right and y up.
///
///   const Point middle = lerp(a, b, 0.5);
///   const double d = distance_to_segment(p, a, b);
///
/// The only header that names Eigen's type: everything else says Point.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <string>
#include <vector>

namespace oxturn {

using Point = Eigen::Vector2d;
using Polyline = std::vector<Point>;

inline constexpr double kPi = 3.14159265358979323846;

/// z of the cross product: positive if b lies counter-clockwise of a. Rounded: for decisions use orientation().
inline double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }
inline double distance(const Point& a, const Point& b) { return (a - b).norm(); }
inline bool finite(const Point& p) { return std::isfinite(p.x()) && std::isfinite(p.y()); }
inline Point lerp(const Point& a, const Point& b, double t) { return a + t * (b - a); }
/// v turned counter-clockwise by 90 degrees.
inline Point perpendicular(const Point& v) { return {-v.y(), v.x()}; }
/// Lexicographic order: by x, then by y.
inline bool before(const Point& a, const Point& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); }

/// "(2, 3)" for messages, with the shortest decimals that read back as the same numbers.
std::string to_text(const Point& p);

/// The point of the segment ab nearest to p; a == b is allowed.
inline Point nearest_on_segment(const Point& p, const Point& a, const Point& b) {
  const Point d = b - a;
  const double len2 = d.squaredNorm();
  if (len2 <= 0) return a;
  const double t = (p - a).dot(d) / len2;
  return t <= 0 ? a : t >= 1 ? b : Point(a + t * d);
}
inline double distance_to_segment(const Point& p, const Point& a, const Point& b) {
  return distance(p, nearest_on_segment(p, a, b));
}

inline double length(const Polyline& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.size(); ++i) sum += distance(line[i - 1], line[i]);
  return sum;
}

/// Axis-parallel box; empty until a point is added.
struct Box {
  Point low{1e300, 1e300}, high{-1e300, -1e300};
  void add(const Point& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  void add(const Box& o) {
    low = low.cwiseMin(o.low);
    high = high.cwiseMax(o.high);
  }
  void grow(double by) {
    low.array() -= by;
    high.array() += by;
  }
  bool empty() const { return low.x() > high.x() || low.y() > high.y(); }
  bool contains(const Point& p) const {
    return p.x() >= low.x() && p.x() <= high.x() && p.y() >= low.y() && p.y() <= high.y();
  }
  bool overlaps(const Box& o) const {
    return low.x() <= o.high.x() && o.low.x() <= high.x() && low.y() <= o.high.y() && o.low.y() <= high.y();
  }
  Point size() const { return high - low; }
  Point centre() const { return (low + high) / 2; }
};

}  // namespace oxturn
