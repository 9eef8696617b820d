// Does a segment stay in a region, but for rounding?
#pragma once

#include <optional>

#include "geometry/edge_index.hpp"

namespace oxturn {

/// In the closed region, or within `tolerance` of its boundary.
bool nearly_contains(const EdgeIndex& walls, const Point& p, double tolerance);
/// A place of ab that is more than `tolerance` outside; none if there is none. The segment is cut where it may meet a
/// wall, and each part is judged at its ends and in its middle.
std::optional<Point> point_outside(const EdgeIndex& walls, const Point& a, const Point& b, double tolerance);

}  // namespace oxturn
