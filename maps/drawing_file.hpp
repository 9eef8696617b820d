/// Drawings as areas and as files. GeoJSON: a FeatureCollection of strokes (LineString) and areas (Polygon);
/// docs/drawings.md has its properties.
///
///   const Drawing copy = drawing_from_geojson(to_geojson(drawing), "copy.geojson");
#pragma once

#include <string>

#include "maps/drawing.hpp"

namespace oxturn {

/// What is to be covered: the filled areas, and the strokes as wide as they are drawn. Strokes with the tool off do not
/// count. Errs inside, by a thousandth of a stroke's width. Empty if nothing has an area.
Region drawn_area(const Drawing& drawing);
/// Canonical bytes of everything but the file's hash, for content addresses.
std::string canonical_bytes(const Drawing& drawing);

/// Metres, shortest round-trip numbers.
std::string to_geojson(const Drawing& drawing);
/// `source` is named in messages. Throws std::invalid_argument that names the feature.
Drawing drawing_from_geojson(const std::string& text, const std::string& source);

}  // namespace oxturn
