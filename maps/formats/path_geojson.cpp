// Paths as GeoJSON: a FeatureCollection of LineStrings with `tool`, and `reverse` where that is true and `width` where
// a part of the tool is used, in driving order.
//
// Paths are not judged here: jumps, walls and wrong starts concern the score. A coordinate that JSON cannot represent
// (NaN) is written as null, which the reader refuses, naming the point.
#include <fmt/format.h>

#include "base/text.hpp"
#include "maps/formats/geojson.hpp"
#include "maps/formats/robot_json.hpp"
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
  Gear gear = Gear::forward;
  if (const Json* reverse = properties.find("reverse")) {
    if (!reverse->is_boolean()) JsonAt{*reverse, feature.where + ", reverse"}.refuse("true or false");
    if (reverse->get<bool>()) gear = Gear::reverse;
  }
  double width = 0;
  if (const Json* part = properties.find("width")) {
    const JsonAt at{*part, feature.where + ", width"};
    width = at.number("metres from 0");
    if (width < 0) at.refuse("metres from 0");
  }
  const JsonAt points{member(geometry, "coordinates", "a list of points"), feature.where + ", coordinates"};
  if (!points.value.is_array() || points.value.size() < 2) points.refuse("a list of at least two points");
  return {tool.value.get<bool>(), points.points(feature.where), gear, width};
}

std::string problem_text(const PathProblem& problem) {
  const MapSource& source = problem.source;
  std::string text = "{\n";
  if (source.file.empty())
    text += fmt::format("\"generator\": {}, \"seed\": {}", json_text(source.generator), source.seed);
  else
    text += "\"file\": " + json_text(source.file);
  if (!source.settings.empty()) text += ", \"settings\": " + settings_text(source.settings);
  if (!source.target.empty()) text += ", \"target\": " + json_text(source.target);
  return text + fmt::format(",\n\"map_sha256\": {},\n\"start\": {}, \"anchor\": {},\n\"robot\": {}}}",
                            json_text(problem.map_sha256), json_point(problem.start), json_point(problem.anchor),
                            robot_text(problem.robot));
}

PathProblem read_problem(const JsonAt& at, const std::string& source) {
  const auto needed = [&](const char* key, const char* expected) {
    return JsonAt{member(at, key, expected), at.where + "." + key};
  };
  PathProblem problem;
  if (at.value.is_object() && at.find("file") != nullptr) {
    problem.source.file = needed("file", "a map's file").text();
    if (problem.source.file.empty()) needed("file", "").refuse("a map's file");
  } else {
    problem.source.generator = needed("generator", "a generator's name, or file").text();
    const JsonAt seed = needed("seed", "a whole number from 0");
    if (!seed.value.is_number_unsigned()) seed.refuse("a whole number from 0");
    problem.source.seed = seed.value.get<std::uint64_t>();
  }
  if (const Json* settings = at.find("settings"))
    problem.source.settings = read_settings({*settings, at.where + ".settings"});
  if (const Json* target = at.find("target")) problem.source.target = JsonAt{*target, at.where + ".target"}.text();
  problem.map_sha256 = needed("map_sha256", "the hash of the map").text();
  problem.start = needed("start", "a point").point();
  problem.anchor = needed("anchor", "a point").point();
  problem.robot = read_robot(needed("robot", "an object"), source);
  return problem;
}

}  // namespace

std::string to_geojson(const Path& path, const PathProblem* problem) {
  std::string text = "{\"type\": \"FeatureCollection\", \"features\": [";
  for (std::size_t i = 0; i < path.legs.size(); ++i) {
    const Leg& leg = path.legs[i];
    text += fmt::format("{}\n{{\"type\": \"Feature\", \"properties\": {{\"tool\": {}{}{}}}, \"geometry\": ",
                        i > 0 ? "," : "", leg.tool, leg.gear == Gear::reverse ? ", \"reverse\": true" : "",
                        leg.width > 0 ? ", \"width\": " + to_decimal(leg.width) : "");
    text += "{\"type\": \"LineString\", \"coordinates\": ";
    text += json_points(leg.points);
    text += "}}";
  }
  text += "\n]}\n";
  return problem != nullptr ? with_problem(std::move(text), *problem) : text;
}

std::string with_problem(std::string path, const PathProblem& problem) {
  return std::move(path.insert(1, "\"problem\": " + problem_text(problem) + ",\n"));
}

Path path_from(const JsonAt& collection) {
  const std::string& where = collection.where;
  const JsonAt type{member(collection, "type", "FeatureCollection"), where + ": type"};
  if (type.value != "FeatureCollection") type.refuse("FeatureCollection");
  const JsonAt features{member(collection, "features", "a list of LineStrings"), where + ": features"};
  if (!features.value.is_array()) features.refuse("a list of LineStrings");
  Path path;
  path.legs.reserve(features.value.size());
  for (std::size_t i = 0; i < features.value.size(); ++i)
    path.legs.push_back(read_leg({features.value[i], fmt::format("{}: feature {}", where, i + 1)}));
  return path;
}

PathFile path_from_geojson(const std::string& text, const std::string& source) {
  const Json root = parse_json(text, source);
  const JsonAt top{root, source};
  PathFile file{path_from(top), {}};
  if (const Json* problem = top.find("problem")) file.problem = read_problem({*problem, source + ": problem"}, source);
  return file;
}

}  // namespace oxturn
