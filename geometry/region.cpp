#include "geometry/region.hpp"

#include "base/math.hpp"
#include "geometry/ray_crossing.hpp"

namespace oxturn {

double signed_area(const Ring& ring) {
  double twice = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) twice += cross(ring[i - 1] - ring[0], ring[i] - ring[0]);
  return twice / 2;
}

double area(const Polygon& polygon) {
  double sum = std::abs(signed_area(polygon.outer));
  for (const Ring& h : polygon.holes) sum -= std::abs(signed_area(h));
  return sum;
}

double area(const Region& region) {
  double sum = 0;
  for (const Polygon& p : region.polygons) sum += area(p);
  return sum;
}

double perimeter(const Region& region) {
  double sum = 0;
  for_each_edge(region, [&](const Point& a, const Point& b) { sum += distance(a, b); });
  return sum;
}

Box bounding_box(const std::vector<Point>& points) {
  Box box;
  for (const Point& p : points) box.add(p);
  return box;
}

Box bounding_box(const Region& region) {
  Box box;
  for_each_edge(region, [&](const Point& p, const Point&) { box.add(p); });
  return box;
}

std::size_t vertex_count(const Region& region) {
  std::size_t n = 0;
  for_each_ring(region, [&](const Ring& r) { n += r.size(); });
  return n;
}

std::size_t hole_count(const Region& region) {
  std::size_t n = 0;
  for (const Polygon& p : region.polygons) n += p.holes.size();
  return n;
}

bool contains(const Region& region, const Point& p) {
  bool odd = false;
  for_each_edge(region, [&](const Point& a, const Point& b) { odd ^= crosses_ray(a, b, p); });
  return odd;
}

Region box_region(const Point& low, const Point& high) {
  return {{Polygon{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}, {}}}};
}

Region transformed(const Region& region, double angle, const Point& shift) {
  const double c = math::cos(angle), s = math::sin(angle);
  Region out = region;
  for_each_ring(out, [&](Ring& ring) {
    for (Point& p : ring) p = Point(c * p.x() - s * p.y() + shift.x(), s * p.x() + c * p.y() + shift.y());
  });
  return out;
}

}  // namespace oxturn
