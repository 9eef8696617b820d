/// Items in an order in which neighbours in space are mostly near each other: what is asked about one is still in the
/// processor's cache when the next one asks.
///
///   for (const std::size_t k : spatial_order(boxes)) look_at(pieces[k]);
///
/// By the boxes' centres along Morton's space-filling curve; equal positions keep their order. O(n log n).
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

/// The indices of the boxes that are not empty.
std::vector<std::size_t> spatial_order(const std::vector<Box>& boxes);

/// The region's polygons in that order.
void put_neighbours_together(Region& region);

}  // namespace oxturn
