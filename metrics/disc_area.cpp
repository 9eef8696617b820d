#include "metrics/disc_area.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

double sector(double radius, const Point& a, const Point& b) {
  return radius * radius / 2 * std::atan2(cross(a, b), a.dot(b));
}

}  // namespace

double disc_area_of_edge(const Point& centre, double radius, const Point& from, const Point& to) {
  const Point a = from - centre, b = to - centre, d = b - a;
  const double aa = d.squaredNorm(), half = a.dot(d), c = a.squaredNorm() - radius * radius;
  if (!(aa > 0)) return 0;
  const double square = half * half - aa * c;
  if (square <= 0) return sector(radius, a, b);
  const double root = std::sqrt(square), enters = (-half - root) / aa, leaves = (-half + root) / aa;
  if (enters >= 1 || leaves <= 0) return sector(radius, a, b);
  const Point p = enters > 0 ? Point(a + enters * d) : a, q = leaves < 1 ? Point(a + leaves * d) : b;
  double area = cross(p, q) / 2;
  if (enters > 0) area += sector(radius, a, p);
  if (leaves < 1) area += sector(radius, q, b);
  return area;
}

Ring clipped_left(const Ring& ring, const Point& a, const Point& b) {
  Ring kept;
  const auto side = [&](const Point& p) { return cross(b - a, p - a); };
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &p = ring[i], &q = ring[(i + 1) % ring.size()];
    const double at_p = side(p), at_q = side(q);
    if (at_p >= 0) kept.push_back(p);
    if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0)) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
  }
  return kept;
}

}  // namespace oxturn
