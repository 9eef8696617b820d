#include "algorithms/grid/bisector_nodes.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {

std::vector<BisectorNode> bisector_nodes(const Ring& wall, double offset, double miter_limit) {
  Ring vertices;
  for (const Point& p : wall)
    if (vertices.empty() || p != vertices.back()) vertices.push_back(p);
  while (vertices.size() > 1 && vertices.front() == vertices.back()) vertices.pop_back();
  const std::size_t n = vertices.size();
  std::vector<BisectorNode> nodes;
  if (n < 2) return nodes;
  for (std::size_t i = 0; i < n; ++i) {
    const Point& v = vertices[i];
    const Point next = vertices[(i + 1) % n] - v, previous = vertices[(i + n - 1) % n] - v;
    double phi = std::atan2(cross(next, previous), next.dot(previous));
    if (phi < 0) phi += 2 * kPi;
    const double sigma = std::atan2(next.y(), next.x());
    const double theta = sigma + phi / 2 + kPi;
    const Point away(std::cos(theta), std::sin(theta));
    const double s = std::sin(phi / 2);
    // Reflex vertices of the obstacle are never cut: there the robot turns in a corner of free space.
    if (phi >= kPi || s * miter_limit >= 1) {
      // In a cleft so narrow that no point beside its edges is off both, the node stays near, where it will be invalid.
      const double farthest = std::max(next.norm(), previous.norm()) + 2 * offset;
      nodes.push_back({v, v + away * (offset > farthest * s ? farthest : offset / s)});
      continue;
    }
    // Where the line across the bisector, miter_limit * offset off the vertex, meets the two edges' offsets.
    const double out = miter_limit * offset;
    const double aside = (offset - out * s) / std::cos(phi / 2);
    for (const double side : {-1.0, 1.0}) nodes.push_back({v, v + away * out + side * aside * perpendicular(away)});
  }
  return nodes;
}

}  // namespace oxturn
