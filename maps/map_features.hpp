/// Figures that describe a map, for tables that relate results to the kind of map.
///
///   const MapFeatures features = map_features(map);
///   features.area_m2 / (tool_width * tool_width);      // how large the map is for this tool
#pragma once

#include <cstddef>
#include <optional>

#include "maps/map.hpp"

namespace oxturn {

struct MapFeatures {
  double area_m2 = 0, perimeter_m = 0;
  std::size_t holes = 0;
  std::size_t reflex_vertices = 0;  // where the free space's interior angle is above pi
  /// Width of the narrowest passage: the diameter of the smallest disc that cannot go from one part of the free space
  /// to another although it fits into both. At most 2 % too large; nullopt if no passage separates the free space, and
  /// for maps of more than 5000 vertices.
  std::optional<double> narrowest_m;
};

/// O(n log n), with some 60 erosions for the narrowest passage: two to seven times the processor time of a robot's
/// configuration space and target, 0.07 s for 2600 vertices. The limit of 5000 vertices bounds it.
MapFeatures map_features(const Map& map);

}  // namespace oxturn
