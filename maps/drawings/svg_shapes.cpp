#include "maps/drawings/svg_shapes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

namespace oxturn::svg {
namespace {

struct Source {
  const pugi::xml_node& node;
  const Viewport& viewport;
  std::size_t most;  // commands

  double x(const char* name, double fallback = 0) const { return length_of(node, name, viewport.width, fallback); }
  double y(const char* name, double fallback = 0) const { return length_of(node, name, viewport.height, fallback); }
};

/// The whole ellipse, or one of its quarters for a rectangle's corner.
CurveSegment quarter(const Point& centre, double rx, double ry, int from) {
  return arc(centre, {rx, 0}, {0, ry}, from * kPi / 2, kPi / 2);
}

Shape ellipse(const Point& centre, double rx, double ry) {
  if (!finite(centre) || !std::isfinite(rx + ry)) return {{}, 0, "its position or radius is not understood"};
  if (rx < 0 || ry < 0) return {{}, 0, "its radius is negative"};
  if (rx == 0 || ry == 0) return {};  // SVG: not drawn
  Subpath path{{}, true};
  for (int k = 0; k < 4; ++k) path.segments.push_back(quarter(centre, rx, ry, k));
  return {{path}, 4, ""};
}

Shape circle_shape(const Source& s) {
  const double r = length_of(s.node, "r", s.viewport.diagonal(), 0);
  return ellipse({s.x("cx"), s.y("cy")}, r, r);
}
Shape ellipse_shape(const Source& s) { return ellipse({s.x("cx"), s.y("cy")}, s.x("rx"), s.y("ry")); }

/// A line along one side of a rectangle, if it has a length.
void add_side(Subpath& path, const Point& a, const Point& b) {
  if (a != b) path.segments.push_back(line(a, b));
}

Shape rectangle_shape(const Source& s) {
  constexpr double kAuto = -1;
  const double x = s.x("x"), y = s.y("y"), w = s.x("width"), h = s.y("height");
  double rx = s.x("rx", kAuto), ry = s.y("ry", kAuto);
  if (!std::isfinite(x + y + w + h + rx + ry)) return {{}, 0, "its position or size is not understood"};
  if (w < 0 || h < 0) return {{}, 0, "its width or height is negative"};
  if (w == 0 || h == 0) return {};
  rx = rx < 0 ? ry : rx;
  rx = std::clamp(rx, 0.0, w / 2);
  ry = std::clamp(ry < 0 ? rx : ry, 0.0, h / 2);
  const bool round = rx > 0 && ry > 0;
  if (!round) rx = ry = 0;
  Subpath path{{}, true};
  const double right = x + w, bottom = y + h;
  add_side(path, {x + rx, y}, {right - rx, y});
  if (round) path.segments.push_back(quarter({right - rx, y + ry}, rx, ry, -1));
  add_side(path, {right, y + ry}, {right, bottom - ry});
  if (round) path.segments.push_back(quarter({right - rx, bottom - ry}, rx, ry, 0));
  add_side(path, {right - rx, bottom}, {x + rx, bottom});
  if (round) path.segments.push_back(quarter({x + rx, bottom - ry}, rx, ry, 1));
  add_side(path, {x, bottom - ry}, {x, y + ry});
  if (round) path.segments.push_back(quarter({x + rx, y + ry}, rx, ry, 2));
  return {{path}, path.segments.size(), ""};
}

Shape line_shape(const Source& s) {
  const Point a(s.x("x1"), s.y("y1")), b(s.x("x2"), s.y("y2"));
  if (!finite(a) || !finite(b)) return {{}, 0, "its ends are not understood"};
  return {{{{line(a, b)}, false}}, 1, ""};
}

Shape points_shape(const Source& s, bool closed) {
  Shape shape;
  Scanner scan(s.node.attribute("points").value());
  Subpath path{{}, closed};
  std::optional<Point> first, last;
  for (scan.skip_blanks(); !scan.done() && shape.problem.empty(); scan.skip_separator()) {
    const auto x = scan.number();
    scan.skip_separator();
    const auto y = x ? scan.number() : std::nullopt;
    if (!y || ++shape.commands > s.most) {
      shape.problem = "its points are not pairs of numbers: it is drawn up to there";
      break;
    }
    const Point p(*x, *y);
    if (last) path.segments.push_back(line(*last, p));
    if (!first) first = p;
    last = p;
  }
  if (path.segments.empty()) return shape;
  if (closed && *last != *first) path.segments.push_back(line(*last, *first));
  path.closed = closed || *last == *first;
  shape.outline.push_back(std::move(path));
  return shape;
}

Shape path_shape(const Source& s) {
  ParsedPath data = parse_path(s.node.attribute("d").value(), s.most);
  return {std::move(data.outline), data.commands,
          data.broken
              ? fmt::format("its path data has an error after command {}: it is drawn up to there", data.commands)
              : ""};
}

const std::map<std::string_view, Shape (*)(const Source&)>& shapes() {
  static const std::map<std::string_view, Shape (*)(const Source&)> kAll{
      {"path", path_shape},
      {"rect", rectangle_shape},
      {"circle", circle_shape},
      {"ellipse", ellipse_shape},
      {"line", line_shape},
      {"polyline", [](const Source& s) { return points_shape(s, false); }},
      {"polygon", [](const Source& s) { return points_shape(s, true); }}};
  return kAll;
}

}  // namespace

bool is_shape(std::string_view name) { return shapes().contains(name); }

Shape shape_of(std::string_view name, const pugi::xml_node& node, const Viewport& viewport, std::size_t most) {
  return shapes().at(name)({node, viewport, most});
}

double length_of(const pugi::xml_node& node, const char* attribute, double whole, double fallback) {
  const pugi::xml_attribute found = node.attribute(attribute);
  if (!found || std::string_view(found.value()) == "auto") return fallback;
  return parse_length(found.value(), whole).value_or(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace oxturn::svg
