/// The shortest bridges between the rings of polygons: cut along them, a region has no holes any more.
///
///   const Region open = cut_along(space, shortest_bridges(space), 1e-3);
///
/// By Boruvka's algorithm: in each round every connected component but the largest finds what is nearest to it, in a
/// grid, and no farther away than the nearest that it has found so far. O(n log n) for n edges of usual maps; O(n^2)
/// where many edges of one ring are as near to many edges of another.
#pragma once

#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

/// Straight lines inside the region that connect all rings of each polygon: their minimum spanning tree by distance.
/// The shortest first; each from the ring that is stored first.
std::vector<Polyline> shortest_bridges(const Region& region);

}  // namespace oxturn
