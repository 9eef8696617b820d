/// A region of the plane: disjoint polygons with holes, in metres.
///
///   Region room = box_region({0, 0}, {4, 3});
///   room.polygons[0].holes.push_back({{1, 1}, {1, 2}, {2, 2}, {2, 1}});
///   area(room);                                 // 11
///
/// Outer rings run counter-clockwise, holes clockwise, so that the interior is to the left of every edge. No ring
/// repeats its first point. Interiors of polygons are disjoint; rings may touch in points. repaired() in validity.hpp
/// brings other data into this form.
#pragma once

#include <cstddef>

#include "base/math.hpp"
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

/// Positive for a counter-clockwise ring. Computed relative to the first point, so that distance from the origin costs
/// no precision.
double signed_area(const Ring& ring);
/// Square metres, without the holes.
double area(const Polygon& polygon);
double area(const Region& region);
/// Total length of all rings, metres.
double perimeter(const Region& region);
Box bounding_box(const std::vector<Point>& points);
Box bounding_box(const Region& region);
std::size_t vertex_count(const Region& region);
std::size_t hole_count(const Region& region);
/// Calls f(ring) for every ring, outer first, in stored order; f may change the rings of a region that is not constant.
template <class R, class F>
void for_each_ring(R&& region, F f) {
  for (auto& p : region.polygons) {
    f(p.outer);
    for (auto& h : p.holes) f(h);
  }
}
/// Calls f(a, b) for every edge, ring by ring from its first vertex on.
template <class F>
void for_each_edge(const Ring& ring, F f) {
  for (std::size_t i = 0; i < ring.size(); ++i) f(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]);
}
template <class F>
void for_each_edge(const Region& region, F f) {
  for_each_ring(region, [&](const Ring& ring) { for_each_edge(ring, f); });
}
/// Is p inside? Even-odd rule over all edges, O(n); points on the boundary may give either answer. For many queries
/// build an EdgeIndex.
bool contains(const Region& region, const Point& p);

Region box_region(const Point& low, const Point& high);
/// Rotated by `angle` radians about the origin, then shifted.
Region transformed(const Region& region, double angle, const Point& shift);
inline Point rotated(const Point& p, double angle) {
  const double c = math::cos(angle), s = math::sin(angle);
  return {c * p.x() - s * p.y(), s * p.x() + c * p.y()};
}

}  // namespace oxturn
