/// Parts of GeoJSON for messages between programs. Internal: not installed.
///
///   text += ", \"target\": " + to_geojson(problem.target());
///   const Path path = path_from({message["path"], "line 3: path"});
#pragma once

#include "geometry/path.hpp"
#include "geometry/region.hpp"
#include "maps/drawing.hpp"
#include "maps/formats/json.hpp"

namespace oxturn {

/// A Polygon or MultiPolygon.
std::string to_geojson(const Region& region);
/// The repaired region of a Polygon or MultiPolygon. Throws std::invalid_argument that begins with where it is.
Region region_from(const JsonAt& geometry);
/// The strokes and areas of a FeatureCollection. Throws std::invalid_argument that names the feature.
Drawing drawing_from(const JsonAt& collection);
/// The legs of a FeatureCollection of LineStrings with `tool`. Throws std::invalid_argument that names the feature.
Path path_from(const JsonAt& collection);

}  // namespace oxturn
