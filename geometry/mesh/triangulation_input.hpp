/// The input of a triangulation: different points, and segments between them. Private to geometry, not installed.
#pragma once

#include <cstdint>
#include <utility>

#include "geometry/region.hpp"

namespace oxturn {

struct TriangulationInput {
  using Segment = std::pair<std::int32_t, std::int32_t>;  // of points; the lower index first
  std::vector<Point> points;
  std::vector<Segment> edges;     // of the region's boundary
  std::vector<Segment> barriers;  // sorted, no repeats
};

/// The region's different vertices in input order, and the edges that occur an odd number of times (the others bound
/// nothing). Barriers are added if there are at least three edges; an end of a barrier that lies on an edge, up to
/// rounding, splits it. Throws std::invalid_argument for points that are not finite. O(n log n).
TriangulationInput triangulation_input(const Region& region, const std::vector<Polyline>& barriers);

}  // namespace oxturn
