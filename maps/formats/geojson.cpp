// Maps and problems as GeoJSON (RFC 7946 in shape), coordinates in planar metres.
//
// Reads      a Feature, a bare Polygon or MultiPolygon, or a FeatureCollection with exactly one polygonal feature.
// Decisions  1. Rings may run either way and may or may not repeat their first point.
//            2. The region is repaired here, so that a flaw is named with the file; what changed is a remark.
//            3. Coordinates that look like degrees are taken as metres all the same: there is no telling them apart.
//            4. Foreign properties are let through, foreign keys of `robot` are not: a typing error there would
//               silently plan for another robot.
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "geometry/overlay/validity.hpp"
#include "maps/formats/json.hpp"
#include "maps/formats/readers.hpp"
#include "base/files.hpp"

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
  if (type == nullptr || !type->is_string())
    throw std::invalid_argument(fmt::format("{} has no type, expected {}", object.place, expected));
  return type->get<std::string>();
}

Ring read_ring(const JsonAt& at) {
  if (!at.value.is_array()) at.refuse("a list of points");
  Ring ring;
  ring.reserve(at.value.size());
  for (std::size_t i = 0; i < at.value.size(); ++i) {
    const Json& v = at.value[i];
    if (v.is_array() && v.size() >= 2 && v[0].is_number() && v[1].is_number()) {
      const Point p(v[0].get<double>(), v[1].get<double>());
      if (finite(p)) {
        ring.push_back(p);
        continue;
      }
    }
    ring.push_back(JsonAt{v, fmt::format("{}, point {}", at.place, i + 1)}.point());  // says what is wrong
  }
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (ring.size() < 3)
    throw std::invalid_argument(fmt::format("{} has {} different points, expected at least 3", at.place, ring.size()));
  return ring;
}

Polygon read_polygon(const JsonAt& at) {
  if (!at.value.is_array() || at.value.empty()) at.refuse("a list of rings, the outer one first");
  Polygon polygon;
  for (std::size_t i = 0; i < at.value.size(); ++i) {
    Ring ring = read_ring({at.value[i], fmt::format("{}, ring {}", at.place, i + 1)});
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
    throw std::invalid_argument(fmt::format("{} is a {}, expected a Polygon or MultiPolygon", at.place, type));
  if (coordinates == nullptr || !coordinates->is_array() || coordinates->empty())
    throw std::invalid_argument(fmt::format("{} has no coordinates, expected a list of rings", at.place));
  Region region;
  if (type == "Polygon") {
    region.polygons.push_back(read_polygon({*coordinates, file + ": polygon 1"}));
  } else {
    for (std::size_t i = 0; i < coordinates->size(); ++i)
      region.polygons.push_back(read_polygon({(*coordinates)[i], fmt::format("{}: polygon {}", file, i + 1)}));
  }
  return region;
}

/// `object` has only keys from the list.
void only_keys(const JsonAt& object, const std::vector<std::string>& keys) {
  if (!object.value.is_object()) object.refuse("an object");
  for (const auto& item : object.value.items())
    if (std::find(keys.begin(), keys.end(), item.key()) == keys.end())
      throw std::invalid_argument(
          fmt::format("{} has an unknown key '{}'; it may have: {}", object.place, item.key(), fmt::join(keys, ", ")));
}

Robot read_robot(const JsonAt& at, const std::string& file) {
  only_keys(at, {"name", "radius", "tool_width", "speed", "acceleration", "turn_rate", "min_turn_radius", "tether",
                 "lidar", "footprint"});
  Robot robot;
  const auto read = [&](const char* key, double& member) {
    if (const Json* v = at.find(key)) member = JsonAt{*v, fmt::format("{}: robot.{}", file, key)}.number();
  };
  if (const Json* v = at.find("name")) robot.name = JsonAt{*v, file + ": robot.name"}.text();
  read("radius", robot.radius);
  read("tool_width", robot.tool_width);
  read("speed", robot.speed);
  read("acceleration", robot.acceleration);
  read("turn_rate", robot.turn_rate);
  read("min_turn_radius", robot.min_turn_radius);
  const auto member = [&](const JsonAt& object, const char* key) -> JsonAt {
    const Json* v = object.find(key);
    if (v == nullptr) throw std::invalid_argument(fmt::format("{} has no {}", object.place, key));
    return {*v, fmt::format("{}.{}", object.place, key)};
  };
  if (const Json* v = at.find("tether")) {
    const JsonAt tether{*v, file + ": robot.tether"};
    only_keys(tether, {"length", "reach", "sharp_angle"});
    Tether& read_into = robot.tether.emplace();
    if (tether.find("reach") != nullptr) read_into.reach = member(tether, "reach").number();
    if (tether.find("length") != nullptr || tether.find("reach") == nullptr)
      read_into.length = member(tether, "length").number();
    if (tether.find("sharp_angle") != nullptr) read_into.sharp_angle = member(tether, "sharp_angle").number();
  }
  if (const Json* v = at.find("lidar")) {
    const JsonAt lidar{*v, file + ": robot.lidar"};
    only_keys(lidar, {"range", "rays", "noise"});
    const JsonAt rays = member(lidar, "rays");
    if (!rays.value.is_number_integer() || rays.value < 1 || rays.value > 1000000)
      rays.refuse("a whole number from 1 to 1000000");
    robot.lidar = Lidar{member(lidar, "range").number(), rays.value.get<int>(), 0};
    if (lidar.find("noise") != nullptr) robot.lidar->noise = member(lidar, "noise").number();
  }
  if (const Json* v = at.find("footprint")) {
    const JsonAt footprint{*v, file + ": robot.footprint"};
    if (at.find("radius") != nullptr)
      throw std::invalid_argument(fmt::format("{} has a radius and a footprint, expected one of the two", at.place));
    if (v->is_array())
      for (std::size_t i = 0; i < v->size(); ++i)
        robot.footprint.push_back(JsonAt{(*v)[i], fmt::format("{}, corner {}", footprint.place, i + 1)}.point());
    else if (!v->is_string())
      footprint.refuse("a list of corners [x, y], or \"square:WIDTH\" or \"octagon:WIDTH\"");
    if (v->is_array() && v->empty()) footprint.refuse("at least 3 corners");
  }
  try {
    if (const Json* v = at.find("footprint"); v != nullptr && v->is_string())
      robot.footprint = named_footprint(v->get<std::string>());
    check(robot);
  } catch (const std::invalid_argument& e) { throw std::invalid_argument(fmt::format("{}: {}", file, e.what())); }
  return robot;
}

/// The one polygonal feature of a collection.
const Json& only_feature(const JsonAt& collection, std::vector<std::string>& remarks) {
  const Json* features = collection.find("features");
  if (features == nullptr || !features->is_array())
    throw std::invalid_argument(
        fmt::format("{} has no features, expected a list with one polygonal feature", collection.place));
  const Json* found = nullptr;
  std::size_t polygonal = 0;
  for (const Json& feature : *features) {
    const auto geometry = feature.is_object() ? feature.find("geometry") : feature.end();
    if (!feature.is_object() || geometry == feature.end() || !is_polygonal(*geometry)) continue;
    if (found == nullptr) found = &feature;
    ++polygonal;
  }
  if (polygonal != 1)
    throw std::invalid_argument(fmt::format(
        "{} has {} features that are a Polygon or MultiPolygon, expected exactly one", collection.place, polygonal));
  if (features->size() > 1)
    remarks.push_back(fmt::format("{} features that are no polygons are not used", features->size() - 1));
  return *found;
}

std::string ring_text(const Ring& ring) {
  std::string text = "[";
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    if (i > 0) text += ", ";
    text += json_point(ring[i % ring.size()]);
  }
  return text + "]";
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

std::string robot_text(const Robot& r) {
  std::string size = "\"radius\": " + json_number(r.radius);
  if (!r.footprint.empty()) {
    size = "\"footprint\": [";
    for (std::size_t i = 0; i < r.footprint.size(); ++i) size += (i > 0 ? ", " : "") + json_point(r.footprint[i]);
    size += "]";
  }
  std::string text = fmt::format(
      "{{\"name\": {}, {}, \"tool_width\": {}, \"speed\": {}, \"acceleration\": {}, \"turn_rate\": {}, "
      "\"min_turn_radius\": {}",
      json_text(r.name), size, json_number(r.tool_width), json_number(r.speed), json_number(r.acceleration),
      json_number(r.turn_rate), json_number(r.min_turn_radius));
  if (r.tether)
    text += fmt::format(", \"tether\": {{\"{}\": {}, \"sharp_angle\": {}}}", r.tether->reach > 0 ? "reach" : "length",
                        json_number(r.tether->reach > 0 ? r.tether->reach : r.tether->length),
                        json_number(r.tether->sharp_angle));
  if (r.lidar)
    text += fmt::format(", \"lidar\": {{\"range\": {}, \"rays\": {}, \"noise\": {}}}", json_number(r.lidar->range),
                        r.lidar->rays, json_number(r.lidar->noise));
  return text + "}";
}

std::string feature_text(const Map& map, const Point* start, const Point* anchor, const Robot* robot) {
  std::string text = "{\"type\": \"Feature\",\n\"properties\": {\"name\": " + json_text(map.name);
  if (start) text += ", \"start\": " + json_point(*start);
  if (anchor) text += ", \"anchor\": " + json_point(*anchor);
  if (robot) text += ", \"robot\": " + robot_text(*robot);
  if (!map.source.empty()) text += ", \"source\": " + json_text(map.source);
  return text + "},\n\"geometry\": " + geometry_text(map.free) + "}\n";
}

}  // namespace

MapFile read_geojson(const std::string& file, const ReadOptions& options) {
  const Json root = parse_json(read_file(file), file);
  MapFile result;
  const JsonAt top{root, file};
  const std::string expected = "a GeoJSON Feature, Polygon, MultiPolygon or FeatureCollection";
  const std::string type = type_of(top, expected);
  const Json* feature = nullptr;
  if (type == "FeatureCollection")
    feature = &only_feature(top, result.remarks);
  else if (type == "Feature")
    feature = &root;
  else if (!is_polygonal(root))
    throw std::invalid_argument(fmt::format("{} is a {}, expected {}", file, type, expected));

  static const Json kNothing = Json::object();
  const Json *geometry = &root, *properties = &kNothing;
  if (feature != nullptr) {
    const JsonAt at{*feature, file};
    geometry = at.find("geometry");
    if (geometry == nullptr)
      throw std::invalid_argument(fmt::format("{}: geometry is missing, expected a Polygon or MultiPolygon", file));
    if (const Json* p = at.find("properties")) properties = p;
  }
  const JsonAt props{*properties, file + ": properties"};
  if (!properties->is_object()) props.refuse("an object");

  result.map = {stem_of(file), {}, "file", file};
  if (const Json* v = props.find("name")) result.map.name = JsonAt{*v, file + ": name"}.text();
  if (const Json* v = props.find("source")) result.map.source = JsonAt{*v, file + ": source"}.text();
  if (const Json* v = props.find("start")) result.start = JsonAt{*v, file + ": start"}.point();
  if (const Json* v = props.find("anchor")) result.anchor = JsonAt{*v, file + ": anchor"}.point();
  if (const Json* v = props.find("robot")) result.robot = read_robot({*v, file + ": robot"}, file);

  const Region written = read_geometry({*geometry, file + ": geometry"}, file);
  try {
    result.map.free = repaired(written);
  } catch (const std::invalid_argument& e) { throw std::invalid_argument(fmt::format("{}: {}", file, e.what())); }
  const Region& free = result.map.free;
  if (free.empty()) throw std::invalid_argument(fmt::format("{}: the polygons have no area", file));
  if (written.polygons.size() != free.polygons.size())
    result.remarks.push_back(
        fmt::format("repaired: {} polygons became {}", written.polygons.size(), free.polygons.size()));
  if (hole_count(written) != hole_count(free))
    result.remarks.push_back(fmt::format(
        "repaired: {} holes became {} (those that touch each other are united, those that touch the border cut out)",
        hole_count(written), hole_count(free)));
  if (vertex_count(written) != vertex_count(free))
    result.remarks.push_back(fmt::format("repaired: {} corners became {}", vertex_count(written), vertex_count(free)));
  if (options.metres_per_pixel > 0 || options.unknown_is_free || options.drop_speckle_m2 > 0 || options.simplify_m > 0)
    result.remarks.push_back("scale, unknown, speckle and simplify are for pictures and not used here");
  return result;
}

std::string to_geojson(const Problem& problem) {
  return feature_text(problem.map(), &problem.start(), &problem.anchor(), &problem.robot());
}

std::string to_geojson(const MapFile& file) {
  return feature_text(file.map, file.start ? &*file.start : nullptr, file.anchor ? &*file.anchor : nullptr,
                      file.robot ? &*file.robot : nullptr);
}

}  // namespace oxturn
