/// The region that closed curves enclose by a fill rule, as in vector graphics.
///
///   const Region letter = enclosed({outer, counter}, FillRule::nonzero);
///
/// Rings may cross themselves and each other and run in any direction. Source: SVG 1.1, section 11.3.
#pragma once

#include "geometry/region.hpp"

namespace oxturn {

enum class FillRule { nonzero, evenodd };

/// O((n + k) log n) for n edges that meet k times (boolean.hpp). Throws std::invalid_argument for coordinates that are
/// not finite.
Region enclosed(const std::vector<Ring>& rings, FillRule rule);

}  // namespace oxturn
