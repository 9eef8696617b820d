/// Paths as files: GeoJSON FeatureCollections of LineStrings with the property `tool`, in driving order.
///
///   const Path path = read_path("plan.geojson");
///   write_file("copy.geojson", to_geojson(path));
#pragma once

#include <string>

#include "geometry/path.hpp"

namespace oxturn {

/// Coordinates in metres, shortest round-trip numbers. `problem`: the name of the problem's file, written as a member
/// of that name (RFC 7946, section 6.1) if it is not empty.
std::string to_geojson(const Path& path, const std::string& problem = "");
/// Reads what to_geojson writes; throws std::invalid_argument that names `source` (a file's name) and the feature.
Path path_from_geojson(const std::string& text, const std::string& source);
Path read_path(const std::string& file);

}  // namespace oxturn
