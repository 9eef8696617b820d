#include "algorithms/grid/wall_loops.hpp"

#include <algorithm>
#include <cmath>

#include "base/math.hpp"

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
    double phi = math::atan2(cross(next, previous), next.dot(previous));
    if (phi < 0) phi += 2 * kPi;
    const double sigma = math::atan2(next.y(), next.x());
    const double theta = sigma + phi / 2 + kPi;
    const Point away(math::cos(theta), math::sin(theta));
    const double s = math::sin(phi / 2);
    // Reflex vertices of the obstacle are never cut: there the robot turns in a corner of free space.
    if (phi >= kPi || s * miter_limit >= 1) {
      // In a cleft so narrow that no point beside its edges is off both, the node stays near, where it will be invalid.
      const double farthest = std::max(next.norm(), previous.norm()) + 2 * offset;
      nodes.push_back({v, v + away * (offset > farthest * s ? farthest : offset / s)});
      continue;
    }
    // Where the line across the bisector, miter_limit * offset off the vertex, meets the two edges' offsets.
    const double out = miter_limit * offset;
    const double aside = (offset - out * s) / math::cos(phi / 2);
    for (const double side : {-1.0, 1.0}) nodes.push_back({v, v + away * out + side * aside * perpendicular(away)});
  }
  return nodes;
}

std::vector<Polyline> node_loops(const std::vector<Point>& vertices, double d_node) {
  Polyline nodes;
  const std::size_t n = vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point &a = vertices[i], &b = vertices[(i + 1) % n];
    const double dist = distance(a, b);
    if (!(dist > 0)) continue;
    nodes.push_back(a);
    const double count = std::max(0.0, std::ceil(dist / d_node - 1));
    const double gap = dist / (count + 1);
    for (double k = 1; k <= count; ++k) nodes.push_back(a + (b - a) * (gap / dist * k));
  }
  std::vector<Polyline> loops;
  Polyline loop;
  const auto close = [&] {
    if (loop.size() > 1) {
      loop.push_back(loop.front());
      loops.push_back(loop);
    }
    loop.clear();
  };
  for (const Point& p : nodes) {
    if (!loop.empty() && p == loop.front()) close();
    loop.push_back(p);
  }
  close();
  return loops;
}

std::vector<NodeChain> chains_of(const Polyline& loop, const std::vector<bool>& invalid) {
  const auto first = static_cast<std::size_t>(std::find(invalid.begin(), invalid.end(), true) - invalid.begin());
  if (first == invalid.size()) return {{loop, true}};
  const std::size_t n = loop.size() - 1;  // without the duplicate
  std::vector<NodeChain> chains;
  bool in_chain = false;
  for (std::size_t step = 1; step < n; ++step) {  // once around, from the first gap on
    const std::size_t k = (first + step) % n;
    if (!invalid[k]) {
      if (!in_chain) chains.push_back({{}, false});
      chains.back().nodes.push_back(loop[k]);
    }
    in_chain = !invalid[k];
  }
  return chains;
}

}  // namespace oxturn
