// Maps and problems as GeoJSON (RFC 7946 in shape), coordinates in planar metres.
//
// Reads      a Feature, a Polygon or MultiPolygon, or a FeatureCollection with exactly one polygonal feature.
// Decisions  1. Rings may run either way and may or may not repeat their first point.
//            2. The region is repaired here, so that a flaw is reported with the file; what changed is a remark.
//            3. Coordinates that look like degrees are taken as metres as well: the two cannot be told apart.
//            4. A drawing is the member `drawing` of the Feature, a FeatureCollection beside `geometry`, the canvas.
//            5. Unknown properties are ignored, but unknown keys of `robot` are refused: a typing error there would
//               silently plan for another robot.
#include "maps/formats/geojson.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "base/files.hpp"
#include "geometry/overlay/validity.hpp"
#include "maps/drawing_file.hpp"
#include "maps/formats/readers.hpp"
#include "maps/formats/robot_json.hpp"

namespace oxturn {
namespace {

using Json = nlohmann::json;

bool is_polygonal(const Json& geometry) {
  if (!geometry.is_object()) return false;
  const auto type = geometry.find("type");
  return type != geometry.end() && type->is_string() && (*type == "Polygon" || *type == "MultiPolygon");
}

std::string type_of(const JsonAt& object, const std::string& expected) {
  if (!object.value.is_object()) object.refuse(expected);
  const Json* type = object.find("type");
  if (type == nullptr || !type->is_string()) throw_invalid("{} has no type, expected {}", object.where, expected);
  return type->get<std::string>();
}

Ring read_ring(const JsonAt& at) {
  if (!at.value.is_array()) at.refuse("a list of points");
  Ring ring = at.points(at.where);
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (ring.size() < 3) throw_invalid("{} has {} different points, expected at least 3", at.where, ring.size());
  return ring;
}

Polygon read_polygon(const JsonAt& at) {
  if (!at.value.is_array() || at.value.empty()) at.refuse("a list of rings, the outer one first");
  Polygon polygon;
  for (std::size_t i = 0; i < at.value.size(); ++i) {
    Ring ring = read_ring({at.value[i], fmt::format("{}, ring {}", at.where, i + 1)});
    if (i == 0)
      polygon.outer = std::move(ring);
    else
      polygon.holes.push_back(std::move(ring));
  }
  return polygon;
}

Region read_geometry(const JsonAt& at, const std::string& file) {
  const std::string type = type_of(at, "a Polygon or MultiPolygon");
  const Json* coordinates = at.find("coordinates");
  if (type != "Polygon" && type != "MultiPolygon")
    throw_invalid("{} is a {}, expected a Polygon or MultiPolygon", at.where, type);
  if (coordinates == nullptr || !coordinates->is_array() || coordinates->empty())
    throw_invalid("{} has no coordinates, expected a list of rings", at.where);
  Region region;
  if (type == "Polygon") {
    region.polygons.push_back(read_polygon({*coordinates, file + ": polygon 1"}));
  } else {
    for (std::size_t i = 0; i < coordinates->size(); ++i)
      region.polygons.push_back(read_polygon({(*coordinates)[i], fmt::format("{}: polygon {}", file, i + 1)}));
  }
  return region;
}

/// The one polygonal feature of a collection.
const Json& only_feature(const JsonAt& collection, std::vector<std::string>& remarks) {
  const Json* features = collection.find("features");
  if (features == nullptr || !features->is_array())
    throw_invalid("{} has no features, expected a list with one polygonal feature", collection.where);
  const Json* found = nullptr;
  std::size_t polygonal = 0;
  for (const Json& feature : *features) {
    const auto geometry = feature.is_object() ? feature.find("geometry") : feature.end();
    if (!feature.is_object() || geometry == feature.end() || !is_polygonal(*geometry)) continue;
    if (found == nullptr) found = &feature;
    ++polygonal;
  }
  if (polygonal != 1)
    throw_invalid("{} has {} features that are a Polygon or MultiPolygon, expected exactly one", collection.where,
                  polygonal);
  if (features->size() > 1)
    remarks.push_back(fmt::format("{} features that are not polygons are ignored", features->size() - 1));
  return *found;
}

/// With the first point once more at the end.
std::string ring_text(Ring ring) {
  ring.push_back(ring.front());
  return json_points(ring);
}

std::string polygon_text(const Polygon& polygon) {
  std::string text = "[" + ring_text(polygon.outer);
  for (const Ring& hole : polygon.holes) text += ",\n" + ring_text(hole);
  return text + "]";
}

std::string geometry_text(const Region& region) {
  if (region.polygons.size() == 1)
    return "{\"type\": \"Polygon\", \"coordinates\": " + polygon_text(region.polygons.front()) + "}";
  std::string text = "{\"type\": \"MultiPolygon\", \"coordinates\": [";
  for (std::size_t i = 0; i < region.polygons.size(); ++i)
    text += (i > 0 ? ",\n" : "") + polygon_text(region.polygons[i]);
  return text + "]}";
}

std::string feature_text(const Map& map, const Point* start, const Point* anchor, const Robot* robot) {
  std::string text = "{\"type\": \"Feature\",\n\"properties\": {\"name\": " + json_text(map.name);
  if (start) text += ", \"start\": " + json_point(*start);
  if (anchor) text += ", \"anchor\": " + json_point(*anchor);
  if (robot) text += ", \"robot\": " + robot_text(*robot);
  if (!map.source.empty()) text += ", \"source\": " + json_text(map.source);
  if (map.target_area) text += ", \"target\": " + geometry_text(*map.target_area);
  text += "},\n\"geometry\": " + geometry_text(map.free);
  if (map.drawing) text += ",\n\"drawing\": " + to_geojson(*map.drawing);
  return text + "}\n";
}

struct NoOptions {};

/// Where a problem's parts are in a file.
struct Parts {
  const Json* geometry;
  const Json* properties;
  const Json* drawing;  // nullptr: none
};

Parts parts_of(const Json& root, const std::string& file, std::vector<std::string>& remarks) {
  static const Json kNone = Json::object();
  const std::string expected = "a GeoJSON Feature, Polygon, MultiPolygon or FeatureCollection";
  const std::string type = type_of({root, file}, expected);
  if (is_polygonal(root)) return {&root, &kNone, nullptr};
  if (type != "Feature" && type != "FeatureCollection") throw_invalid("{} is a {}, expected {}", file, type, expected);
  const JsonAt feature{type == "Feature" ? root : only_feature({root, file}, remarks), file};
  const Json* geometry = feature.find("geometry");
  if (geometry == nullptr) throw_invalid("{}: geometry is missing, expected a Polygon or MultiPolygon", file);
  const Json* properties = feature.find("properties");
  return {geometry, properties != nullptr ? properties : &kNone, feature.find("drawing")};
}

void read_properties(const JsonAt& properties, const std::string& file, MapFile& result) {
  if (!properties.value.is_object()) properties.refuse("an object");
  const auto named = [&](const char* key) -> std::optional<JsonAt> {
    const Json* value = properties.find(key);
    if (value == nullptr) return std::nullopt;
    return JsonAt{*value, fmt::format("{}: {}", file, key)};
  };
  if (const auto name = named("name")) result.map.name = name->text();
  if (const auto source = named("source")) result.map.source = source->text();
  if (const auto start = named("start")) result.start = start->point();
  if (const auto anchor = named("anchor")) result.anchor = anchor->point();
  if (const auto robot = named("robot")) result.robot = read_robot(*robot, file);
  if (const auto target = named("target")) result.map.target_area = region_from(*target);
}

/// What the file does not say of the target and the start, the drawing does.
void read_drawing(const JsonAt& at, MapFile& result) {
  Drawing drawing = drawing_from(at);
  if (!result.start) result.start = drawing.start;
  if (Region drawn = drawn_area(drawing); !result.map.target_area && !drawn.empty())
    result.map.target_area = std::move(drawn);
  result.map.drawing = std::make_shared<const Drawing>(std::move(drawing));
}

MapFile read_geojson(const std::string& file, const NoOptions&) {
  const Json root = parse_json(read_file(file), file);
  MapFile result;
  result.map = {stem_of(file), {}, "file", file};
  const Parts parts = parts_of(root, file, result.remarks);
  read_properties({*parts.properties, file + ": properties"}, file, result);
  const Region written = read_geometry({*parts.geometry, file + ": geometry"}, file);
  result.map.free = repaired_region(written, file, result.remarks);
  if (parts.drawing != nullptr) read_drawing({*parts.drawing, file + ": drawing"}, result);
  return result;
}

}  // namespace

std::string to_geojson(const Region& region) { return geometry_text(region); }

Region region_from(const JsonAt& geometry) {
  try {
    return repaired(read_geometry(geometry, geometry.where));
  } catch (const std::invalid_argument& e) {
    const std::string why = e.what();
    if (why.starts_with(geometry.where)) throw;
    throw_invalid("{}: {}", geometry.where, why);
  }
}

MapFormat geojson_format() {
  return describe_format<NoOptions>("geojson", "GeoJSON: Polygon or MultiPolygon in planar metres",
                                    {".geojson", ".json"}, {}, read_geojson, to_geojson);
}

std::string to_geojson(const Problem& problem) {
  return feature_text(problem.map(), &problem.start(), &problem.anchor(), &problem.robot());
}

std::string to_geojson(const MapFile& file) {
  return feature_text(file.map, file.start ? &*file.start : nullptr, file.anchor ? &*file.anchor : nullptr,
                      file.robot ? &*file.robot : nullptr);
}

}  // namespace oxturn
