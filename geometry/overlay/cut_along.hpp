/// A region cut open along lines.
///
///   const Region open = cut_along(space, field.cut_locus(chord_error), 1e-5);
#pragma once

#include "geometry/region.hpp"

namespace oxturn {

/// `region` without thin strips, `width` metres wide, about the lines. The lines may meet, cross and repeat each other;
/// strips of lines that share a point join without a gap; where a line bends a little its strip has a mitre. `width`
/// must be above 2^-26 of the region's extent, far above the rounding of the result. O((n + k) log n) for n edges and
/// segments that meet k times. Throws std::invalid_argument for a smaller width, or coordinates that are not finite.
Region cut_along(const Region& region, const std::vector<Polyline>& lines, double width);

}  // namespace oxturn
