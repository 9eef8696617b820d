/// Where a convex body that does not turn fits inside a region: the Minkowski difference.
///
///   const Region space = erode(free, footprint, Bound::inside);   // where the footprint's reference point may be
#pragma once

#include "geometry/overlay/offset.hpp"

namespace oxturn {

/// All points p for which body + p lies in the region. `body` is convex, counter-clockwise, in metres, with the origin
/// strictly inside. The only error is that of the lattice: the result is that of a body larger (Bound::inside) or
/// smaller (Bound::outside) by about 2^-26 of the extent, which makes it a certain bound.
/// O((n + m c + k) log n) for n edges, c reflex vertices of the region, m vertices of the body and k crossings.
/// Throws std::invalid_argument for coordinates that are not finite and for a body without the origin inside.
Region erode(const Region& region, const Ring& body, Bound bound);

}  // namespace oxturn
