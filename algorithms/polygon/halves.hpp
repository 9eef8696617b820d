/// A region cut into parts that are small enough, each time in the middle across its longer side.
///
///   for (Region& part : halved_until(region, [](const Region& r) { return vertex_count(r) <= 2000; })) ...
///
/// For methods whose time grows faster than the region. O(n log p) for n vertices and p parts.
#pragma once

#include <functional>
#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

/// Neighbouring parts follow each other, mostly. `small` has to hold for every region that is small enough.
std::vector<Region> halved_until(const Region& region, const std::function<bool(const Region&)>& small);

}  // namespace oxturn
