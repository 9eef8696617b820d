/// Does a segment stay in a region, up to a tolerance for rounding?
///
///   if (const auto p = point_outside(walls, a, b, tolerance)) throw ...; // *p is outside
#pragma once

#include <optional>

#include "geometry/edge_index.hpp"

namespace oxturn {

/// Is p in the closed region or within `tolerance` of its boundary?
bool nearly_contains(const EdgeIndex& walls, const Point& p, double tolerance);
/// The same without an index: O(n), for one question about a polygon.
bool nearly_contains(const Polygon& polygon, const Point& p, double tolerance);
/// Does no point of the segment ab lie more than `tolerance` outside? Looks at b first, as most that leave end outside.
bool nearly_contains(const EdgeIndex& walls, const Point& a, const Point& b, double tolerance);
/// A point of the segment ab that is more than `tolerance` outside; nullopt if there is none. The segment is divided
/// where it may meet an edge; each part is tested at its ends and at its midpoint.
std::optional<Point> point_outside(const EdgeIndex& walls, const Point& a, const Point& b, double tolerance);

}  // namespace oxturn
