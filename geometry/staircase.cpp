#include "geometry/staircase.hpp"

namespace oxturn {
namespace {

constexpr double kRightAngle = 1e-6;  // cosine

bool right_angle(const Point& a, const Point& b) {
  const double cosine = a.dot(b);  // times both lengths
  return cosine * cosine <= kRightAngle * kRightAngle * a.squaredNorm() * b.squaredNorm();
}

}  // namespace

bool is_staircase(const Region& region, double longest) {
  std::size_t steps = 0;
  for_each_ring(region, [&](const Ring& ring) {
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Point &a = ring[(i + n - 1) % n], &b = ring[i], &c = ring[(i + 1) % n], &d = ring[(i + 2) % n];
      if (right_angle(b - a, c - b) && right_angle(c - b, d - c) && distance(b, c) < longest &&
          (cross(b - a, c - b) > 0) != (cross(c - b, d - c) > 0))
        ++steps;
    }
  });
  return 4 * steps >= vertex_count(region);
}

}  // namespace oxturn
