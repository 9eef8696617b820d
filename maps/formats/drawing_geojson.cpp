// Drawings as GeoJSON: strokes are LineStrings with `stroke` (true: tool on) and `width`, areas are Polygons with
// `fill` and what a person chose for them. Connections, curves and the start are members of the collection.
#include <algorithm>

#include "base/text.hpp"
#include "maps/drawing_file.hpp"
#include "maps/formats/geojson.hpp"

namespace oxturn {
namespace {

using Json = nlohmann::json;

constexpr const char* kAnyFill = "auto";  // left to the planner

std::string positions_text(const std::vector<std::size_t>& positions) {
  return fmt::format("[{}]", fmt::join(positions, ", "));
}
std::string node_text(const NodeOfElement& node) {
  return fmt::format("{{\"element\": {}, \"vertex\": {}}}", json_text(node.element), node.node);
}

std::string stroke_text(const DrawnStroke& s) {
  return fmt::format(
      "{{\"type\": \"Feature\", \"properties\": {{\"element\": {}, \"stroke\": {}, \"width\": {}, \"nodes\": {}, "
      "\"corners\": {}}}, \"geometry\": {{\"type\": \"LineString\", \"coordinates\": {}}}}}",
      json_text(s.element), s.tool, to_decimal(s.width), positions_text(s.nodes), positions_text(s.corners),
      json_points(s.points));
}
std::string area_text(const FilledArea& a) {
  std::string choice = json_text(a.choice.fill.empty() ? kAnyFill : a.choice.fill);
  if (a.choice.angle) choice += ", \"angle\": " + to_decimal(*a.choice.angle);
  if (a.choice.outline) choice += fmt::format(", \"outline\": {}", *a.choice.outline);
  return fmt::format("{{\"type\": \"Feature\", \"properties\": {{\"element\": {}, \"fill\": {}}}, \"geometry\": {}}}",
                     json_text(a.element), choice, to_geojson(Region{{a.area}}));
}

const Json& member(const JsonAt& object, const char* key, const char* expected) {
  const Json* value = object.value.is_object() ? object.find(key) : nullptr;
  if (value == nullptr) throw_invalid("{} has no {}, expected {}", object.where, key, expected);
  return *value;
}
JsonAt at_member(const JsonAt& object, const char* key, const char* expected) {
  return {member(object, key, expected), object.where + ", " + key};
}
bool truth(const JsonAt& at) {
  if (!at.value.is_boolean()) at.refuse("true or false");
  return at.value.get<bool>();
}

/// Increasing positions below `size`.
std::vector<std::size_t> positions(const JsonAt& feature, const char* key, std::size_t size) {
  std::vector<std::size_t> all;
  const Json* list = feature.find(key);
  if (list == nullptr) return all;
  const JsonAt at{*list, feature.where + ", " + key};
  for (const Json& value : *list) {
    const bool fits = value.is_number_unsigned() && value.get<std::uint64_t>() < size &&
                      (all.empty() || value.get<std::uint64_t>() > all.back());
    if (!fits) at.refuse("increasing positions of the line's points");
    all.push_back(value.get<std::size_t>());
  }
  return all;
}

DrawnStroke stroke_from(const JsonAt& properties, const JsonAt& geometry) {
  DrawnStroke s;
  s.tool = truth(at_member(properties, "stroke", "true or false"));
  s.width = at_member(properties, "width", "metres above 0").number("metres above 0");
  if (!(s.width > 0)) at_member(properties, "width", "").refuse("metres above 0");
  const JsonAt points = at_member(geometry, "coordinates", "a list of points");
  if (!points.value.is_array() || points.value.size() < 2) points.refuse("a list of at least two points");
  s.points = points.points(geometry.where);
  s.nodes = positions(properties, "nodes", s.points.size());
  s.corners = positions(properties, "corners", s.points.size());
  if (properties.find("nodes") == nullptr) s.nodes = {0, s.points.size() - 1};
  return s;
}

FillChoice choice_from(const JsonAt& properties) {
  FillChoice choice;
  const JsonAt fill = at_member(properties, "fill", "auto, spiral, zigzag, contour or none");
  choice.fill = fill.text();
  if (choice.fill == kAnyFill) choice.fill.clear();
  const std::string known[] = {"", "spiral", "zigzag", "contour", "none"};
  if (std::ranges::count(known, choice.fill) == 0) fill.refuse("auto, spiral, zigzag, contour or none");
  if (properties.find("angle") != nullptr) choice.angle = at_member(properties, "angle", "").number();
  if (properties.find("outline") != nullptr) choice.outline = truth(at_member(properties, "outline", ""));
  return choice;
}

void add_feature(const JsonAt& feature, Drawing& drawing) {
  const JsonAt geometry = at_member(feature, "geometry", "a LineString or a Polygon");
  const JsonAt properties = at_member(feature, "properties", "an object with stroke or fill");
  const JsonAt type = at_member(geometry, "type", "LineString or Polygon");
  std::string element;
  if (properties.value.is_object() && properties.find("element") != nullptr)
    element = at_member(properties, "element", "").text();
  if (type.value == "LineString") {
    drawing.strokes.push_back(stroke_from(properties, geometry));
    drawing.strokes.back().element = element;
  } else if (type.value == "Polygon" || type.value == "MultiPolygon") {
    const FillChoice choice = choice_from(properties);
    for (Polygon& polygon : region_from(geometry).polygons)
      drawing.areas.push_back({element, std::move(polygon), choice});
  } else {
    type.refuse("LineString or Polygon");
  }
}

NodeOfElement node_from(const JsonAt& at) {
  const JsonAt vertex = at_member(at, "vertex", "a whole number");
  if (!vertex.value.is_number_integer()) vertex.refuse("a whole number");
  return {at_member(at, "element", "an element's name").text(), vertex.value.get<int>()};
}

/// Calls read(item) for each item of the list called `key`, if there is one.
template <class Read>
void for_each_item(const JsonAt& object, const char* key, Read read) {
  const Json* list = object.find(key);
  if (list == nullptr) return;
  if (!list->is_array()) JsonAt{*list, object.where + ": " + key}.refuse("a list");
  for (std::size_t i = 0; i < list->size(); ++i)
    read(JsonAt{(*list)[i], fmt::format("{}: {} {}", object.where, key, i + 1)});
}

}  // namespace

std::string to_geojson(const Drawing& drawing) {
  std::vector<std::string> features, connections, curves;
  for (const DrawnStroke& stroke : drawing.strokes) features.push_back(stroke_text(stroke));
  for (const FilledArea& area : drawing.areas) features.push_back(area_text(area));
  for (const DrawnConnection& c : drawing.connections)
    connections.push_back(
        fmt::format("{{\"enforced\": {}, \"from\": {}, \"to\": {}}}", c.enforced, node_text(c.from), node_text(c.to)));
  for (const DrawnCurve& c : drawing.curves)
    curves.push_back(fmt::format("{{\"kind\": \"{}\", \"from\": {}, \"to\": {}, \"points\": {}}}",
                                 c.kind == DrawnCurve::Kind::spiro ? "spiro" : "bezier", node_text(c.from),
                                 node_text(c.to), json_points(c.points)));
  std::string text = "{\"type\": \"FeatureCollection\"";
  if (drawing.start) text += ", \"start\": " + json_point(*drawing.start);
  if (!drawing.sha256.empty()) text += ", \"sha256\": " + json_text(drawing.sha256);
  if (!connections.empty()) text += fmt::format(",\n\"connections\": [{}]", fmt::join(connections, ",\n"));
  if (!curves.empty()) text += fmt::format(",\n\"curves\": [{}]", fmt::join(curves, ",\n"));
  return text + fmt::format(",\n\"features\": [{}\n]}}\n",
                            features.empty() ? "" : fmt::format("\n{}", fmt::join(features, ",\n")));
}

Drawing drawing_from(const JsonAt& collection) {
  if (!collection.value.is_object() || collection.find("features") == nullptr)
    collection.refuse("a FeatureCollection of strokes and areas");
  Drawing drawing;
  for_each_item(collection, "features", [&](const JsonAt& feature) { add_feature(feature, drawing); });
  if (const Json* start = collection.find("start"))
    drawing.start = JsonAt{*start, collection.where + ": start"}.point();
  if (const Json* hash = collection.find("sha256"))
    drawing.sha256 = JsonAt{*hash, collection.where + ": sha256"}.text();
  for_each_item(collection, "connections", [&](const JsonAt& at) {
    drawing.connections.push_back({node_from(at_member(at, "from", "a node")), node_from(at_member(at, "to", "a node")),
                                   truth(at_member(at, "enforced", "true or false"))});
  });
  for_each_item(collection, "curves", [&](const JsonAt& at) {
    const JsonAt kind = at_member(at, "kind", "spiro or bezier"), points = at_member(at, "points", "a list of points");
    if (kind.value != "spiro" && kind.value != "bezier") kind.refuse("spiro or bezier");
    if (!points.value.is_array()) points.refuse("a list of points");
    drawing.curves.push_back({node_from(at_member(at, "from", "a node")), node_from(at_member(at, "to", "a node")),
                              kind.value == "spiro" ? DrawnCurve::Kind::spiro : DrawnCurve::Kind::bezier,
                              points.points(points.where)});
  });
  return drawing;
}

Drawing drawing_from_geojson(const std::string& text, const std::string& source) {
  const Json root = parse_json(text, source);
  return drawing_from({root, source});
}

}  // namespace oxturn
