// Boolean operations on regions, on an integer lattice (arrangement.hpp).
//
// Coordinates are snapped to a power-of-two quantum of about 2^-30 of the operands' extent (50 m: 0.06
// micrometre), relative to a shared origin; what lies on that lattice already stays where it is. Results are
// canonical regions, valid whatever the operands. O((n + k) log n) for n edges that meet k times, usual data.
// Throws std::invalid_argument for coordinates that are not finite.
#pragma once

#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

Region unite(const std::vector<Region>& parts);
Region intersect(const Region& a, const Region& b);
Region subtract(const Region& a, const Region& b);

}  // namespace oxturn
