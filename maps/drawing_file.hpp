/// Drawings as GeoJSON: a FeatureCollection of strokes (LineString) and areas (Polygon). docs/formats.md has its
/// properties.
///
///   const Drawing copy = drawing_from_geojson(to_geojson(drawing), "copy.geojson");
#pragma once

#include <string>

#include "maps/drawing.hpp"

namespace oxturn {

/// Metres, shortest round-trip numbers.
std::string to_geojson(const Drawing& drawing);
/// `source` is named in messages. Throws std::invalid_argument that names the feature.
Drawing drawing_from_geojson(const std::string& text, const std::string& source);

}  // namespace oxturn
