// How often do the links of a way cross each other?
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/point.hpp"

namespace oxturn {

struct LinkCrossings {
  std::size_t links = 0;     // pairs of segments of `links` whose insides cross in one point
  std::size_t transits = 0;  // such pairs with at least one segment of `transits`
};
/// Exact; touching and running along each other is no crossing. Segments in a grid: O(n + pairs that share a cell).
LinkCrossings count_crossings(const std::vector<Polyline>& links, const std::vector<Polyline>& transits);

}  // namespace oxturn
