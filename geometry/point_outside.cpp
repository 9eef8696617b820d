#include "geometry/point_outside.hpp"

#include <algorithm>
#include <vector>

#include "geometry/ray_crossing.hpp"

namespace oxturn {

bool nearly_contains(const EdgeIndex& walls, const Point& p, double tolerance) {
  return walls.contains(p) || walls.nearest(p, tolerance).has_value();
}

bool nearly_contains(const Polygon& polygon, const Point& p, double tolerance) {
  Box box = bounding_box(polygon.outer);
  box.grow(tolerance);
  if (!box.contains(p)) return false;
  bool odd = false, near = false;
  const auto add = [&](const Ring& ring) {
    for_each_edge(ring, [&](const Point& a, const Point& b) {
      odd ^= crosses_ray(a, b, p);
      near = near || on_segment(p, a, b) || distance_to_segment(p, a, b) < tolerance;
    });
  };
  add(polygon.outer);
  std::ranges::for_each(polygon.holes, add);
  return odd || near;
}

namespace {

/// Of a segment that the region does not contain.
std::optional<Point> first_outside(const EdgeIndex& walls, const Point& a, const Point& b, double tolerance) {
  const Point d = b - a;
  std::vector<double> cuts{0, 1};
  Box box = bounding_box(Polyline{a, b});
  box.grow(tolerance);  // an edge beside the segment may end, too
  walls.for_each_near(box, [&](std::size_t e) {
    const EdgeIndex::Edge& edge = walls.edges()[e];
    const Point side = edge.b - edge.a;
    const double turn = cross(d, side);
    if (turn != 0) cuts.push_back(cross(edge.a - a, side) / turn);
    if (d.squaredNorm() > 0)
      for (const Point& p : {edge.a, edge.b}) cuts.push_back((p - a).dot(d) / d.squaredNorm());
  });
  std::erase_if(cuts, [](double t) { return !(t >= 0 && t <= 1); });
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const Point end = lerp(a, b, cuts[i]);
    if (!nearly_contains(walls, end, tolerance)) return end;
    if (i == 0) continue;
    const Point middle = lerp(a, b, (cuts[i - 1] + cuts[i]) / 2);
    if (!nearly_contains(walls, middle, tolerance)) return middle;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Point> point_outside(const EdgeIndex& walls, const Point& a, const Point& b, double tolerance) {
  return walls.contains(a, b) ? std::nullopt : first_outside(walls, a, b, tolerance);
}

bool nearly_contains(const EdgeIndex& walls, const Point& a, const Point& b, double tolerance) {
  return walls.contains(a, b) || (nearly_contains(walls, b, tolerance) && !first_outside(walls, a, b, tolerance));
}

}  // namespace oxturn
