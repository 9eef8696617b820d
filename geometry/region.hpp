// A region: a set of disjoint polygons with holes, metres.
//
// Outer rings run counter-clockwise, holes clockwise, no ring repeats its first point. Interiors of polygons
// do not meet; rings may touch in points. `repaired` (validity.hpp) brings foreign data into this form.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/point.hpp"

namespace oxturn {

using Ring = std::vector<Point>;

struct Polygon {
  Ring outer;
  std::vector<Ring> holes;
};

struct Region {
  std::vector<Polygon> polygons;
  bool empty() const { return polygons.empty(); }
};

/// Signed area: positive for counter-clockwise. O(n), relative to the first point, so far-off maps lose nothing.
double signed_area(const Ring& ring);
/// Area less holes.
double area(const Polygon& polygon);
double area(const Region& region);
/// Length of all rings.
double perimeter(const Region& region);
Box bounding_box(const Region& region);
std::size_t vertex_count(const Region& region);
std::size_t hole_count(const Region& region);
/// Calls f(ring) for every ring, outer first, in stored order.
template <class F>
void for_each_ring(const Region& region, F f) {
  for (const Polygon& p : region.polygons) {
    f(p.outer);
    for (const Ring& h : p.holes) f(h);
  }
}
/// Even-odd point location by a scan of all edges, O(n): boundary points may go either way.
/// For many questions build an EdgeIndex.
bool contains(const Region& region, const Point& p);

Region box_region(const Point& low, const Point& high);
/// Rotates by `angle` about the origin, then shifts.
Region transformed(const Region& region, double angle, const Point& shift);
inline Point rotated(const Point& p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
}

}  // namespace oxturn
