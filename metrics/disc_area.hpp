/// Area of the intersection of a disc and a polygon, edge by edge.
///
///   double common = 0;
///   for_each_edge(ring, [&](const Point& a, const Point& b) { common += disc_area_of_edge(centre, radius, a, b); });
///
/// Exact but for rounding; rings may be clipped, overlap or run backwards (which counts negative). O(1) an edge.
#pragma once

#include "geometry/region.hpp"

namespace oxturn {

/// Signed area of the disc's part in the triangle of its centre and the edge: positive if a, b run counter-clockwise.
double disc_area_of_edge(const Point& centre, double radius, const Point& a, const Point& b);

/// The ring's part on the left of the directed line from `a` to `b` (Sutherland and Hodgman 1974). Parts of a ring that
/// is not convex stay joined by edges that cancel in every area.
Ring clipped_left(const Ring& ring, const Point& a, const Point& b);

}  // namespace oxturn
