// Where a convex body that does not turn fits inside a region: the region less the Minkowski sum of its walls and the
// reflected body.
#pragma once

#include "geometry/overlay/offset.hpp"
#include "geometry/region.hpp"

namespace oxturn {

/// region (-) body: all points p for which body + p lies in the region. `body` is convex, counter-clockwise, metres, with
/// the origin strictly inside. The only error is that of the lattice: the answer is that of a body larger
/// (Bound::inside) or smaller (Bound::outside) by some 2^-26 of the extent, so it is a certain bound.
/// O((n + m c + k) log n) for n edges, c corners at which the region is reflex, m corners of the body, k crossings.
/// Throws std::invalid_argument for coordinates that are not finite and for a body without the origin inside.
Region erode(const Region& region, const Ring& body, Bound bound);

}  // namespace oxturn
