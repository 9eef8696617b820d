// Curves of a geodesic field, from its cones, triangle by triangle. Private to geometry: not installed.
#pragma once

#include <vector>

#include "geometry/tether/geodesic_cones.hpp"
#include "geometry/tether/geodesic_field.hpp"

namespace oxturn {

std::vector<std::vector<GeodesicField::Arc>> level_of(const GeodesicCones& cones, double l);
std::vector<Polyline> cut_of(const GeodesicCones& cones, double chord);
/// The distance is convex along every cone, so it is largest at a corner or at an end of a piece of the cut.
double farthest_of(const GeodesicCones& cones);

}  // namespace oxturn
