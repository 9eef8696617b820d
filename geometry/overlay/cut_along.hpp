// A region cut open along lines.
#pragma once

#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

/// `region` less thin strips, `width` metres wide, about the lines (which may meet, cross and repeat each other). Where
/// lines share points, the strips join without gaps. Rounding is far below `width`, which must be above 2^-26 of the
/// region's extent. O((n + k) log n).
Region cut_along(const Region& region, const std::vector<Polyline>& lines, double width);

}  // namespace oxturn
