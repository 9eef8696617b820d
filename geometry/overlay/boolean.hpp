/// Boolean operations on regions.
///
///   const Region free = subtract(floor, unite(obstacles));
///
/// Coordinates are snapped to a lattice of about 2^-30 of the operands' extent (50 m: 0.06 micrometres), the same for
/// both operands; a point that lies on it already is not moved. Results are canonical regions, and valid whatever the
/// operands. O((n + k) log n) for n edges that meet k times, usual data; arrangement.hpp has the method, and figures
/// against other libraries. All functions throw std::invalid_argument for coordinates that are not finite.
#pragma once

#include "geometry/region.hpp"

namespace oxturn {

Region unite(const std::vector<Region>& parts);
Region intersect(const Region& a, const Region& b);
Region subtract(const Region& a, const Region& b);
/// What no part covers: subtract(a, unite(parts)) in less than half the time.
Region subtract(const Region& a, const std::vector<Region>& parts);

struct DividedRegion {
  Region outside, inside;
};
/// subtract(region, by) and intersect(region, by) in one overlay.
DividedRegion divided(const Region& region, const Region& by);

}  // namespace oxturn
