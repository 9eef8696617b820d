// Paths as GeoJSON: a FeatureCollection of LineStrings with `tool`, in driving order.
//
// Paths are not judged here: jumps, walls and wrong starts concern the score. A coordinate that JSON cannot represent
// (NaN) is written as null, which the reader refuses, naming the point.
#include <fmt/format.h>

#include "base/files.hpp"
#include "maps/formats.hpp"
#include "maps/formats/json.hpp"
#include "maps/path_file.hpp"

namespace oxturn {
namespace {

using Json = nlohmann::json;

const Json& member(const JsonAt& object, const char* key, const char* expected) {
  if (!object.value.is_object()) object.refuse("an object");
  const Json* value = object.find(key);
  if (value == nullptr) throw_invalid("{} has no {}, expected {}", object.where, key, expected);
  return *value;
}

Leg read_leg(const JsonAt& feature) {
  const JsonAt geometry{member(feature, "geometry", "a LineString"), feature.where + ", geometry"};
  const JsonAt type{member(geometry, "type", "LineString"), geometry.where + ", type"};
  if (type.value != "LineString") type.refuse("LineString");
  const JsonAt properties{member(feature, "properties", "an object with tool"), feature.where + ", properties"};
  const JsonAt tool{member(properties, "tool", "true or false"), feature.where + ", tool"};
  if (!tool.value.is_boolean()) tool.refuse("true or false");
  const JsonAt points{member(geometry, "coordinates", "a list of points"), feature.where + ", coordinates"};
  if (!points.value.is_array() || points.value.size() < 2) points.refuse("a list of at least two points");
  return {tool.value.get<bool>(), points.points(feature.where)};
}

}  // namespace

std::string to_geojson(const Path& path, const std::string& problem) {
  std::string text = "{";
  if (!problem.empty()) text += "\"problem\": " + json_text(problem) + ", ";
  text += "\"type\": \"FeatureCollection\", \"features\": [";
  for (std::size_t i = 0; i < path.legs.size(); ++i) {
    const Leg& leg = path.legs[i];
    text += fmt::format(
        "{}\n{{\"type\": \"Feature\", \"properties\": {{\"tool\": {}}}, \"geometry\": ", i > 0 ? "," : "", leg.tool);
    text += "{\"type\": \"LineString\", \"coordinates\": " + json_points(leg.points) + "}}";
  }
  return text + "\n]}\n";
}

Path path_from_geojson(const std::string& text, const std::string& source) {
  const Json root = parse_json(text, source);
  const JsonAt top{root, source};
  const JsonAt type{member(top, "type", "FeatureCollection"), source + ": type"};
  if (type.value != "FeatureCollection") type.refuse("FeatureCollection");
  const JsonAt features{member(top, "features", "a list of LineStrings"), source + ": features"};
  if (!features.value.is_array()) features.refuse("a list of LineStrings");
  Path path;
  path.legs.reserve(features.value.size());
  for (std::size_t i = 0; i < features.value.size(); ++i)
    path.legs.push_back(read_leg({features.value[i], fmt::format("{}: feature {}", source, i + 1)}));
  return path;
}

Path read_path(const std::string& file) { return path_from_geojson(read_file(file), file); }

}  // namespace oxturn
