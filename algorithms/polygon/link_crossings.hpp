/// Counts how often the links of a path cross each other.
///
///   const LinkCrossings crossings = count_crossings(links, transits);
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/point.hpp"

namespace oxturn {

struct LinkCrossings {
  std::size_t links = 0;     // pairs of segments of `links` that cross in one point interior to both
  std::size_t transits = 0;  // such pairs with at least one segment of `transits`
};
/// Exact. Touching and overlapping are no crossings. O(n + pairs of segments that share a cell of a grid).
LinkCrossings count_crossings(const std::vector<Polyline>& links, const std::vector<Polyline>& transits);

}  // namespace oxturn
