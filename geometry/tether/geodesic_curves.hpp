/// Level sets and cut locus of a geodesic field, from its cones, triangle by triangle. Private to geometry, not
/// installed.
#pragma once

#include <vector>

#include "geometry/tether/geodesic_cones.hpp"
#include "geometry/tether/geodesic_field.hpp"

namespace oxturn {

/// See GeodesicField::level_set, cut_locus and farthest.
std::vector<std::vector<GeodesicField::Arc>> level_set_of(const GeodesicCones& cones, double length);
std::vector<Polyline> cut_locus_of(const GeodesicCones& cones, double chord_error);
double farthest_of(const GeodesicCones& cones);

}  // namespace oxturn
