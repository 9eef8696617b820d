#include "base/sha256.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/swath.hpp"
#include "maps/drawing_file.hpp"
#include "maps/map.hpp"

namespace oxturn {
namespace {

constexpr double kChordError = 1e-3;  // of a stroke's width

void append_text(std::string& bytes, const std::string& text) {
  append_canonical(bytes, std::uint64_t{text.size()});
  bytes += text;
}
void append_points(std::string& bytes, const Polyline& points) {
  append_canonical(bytes, std::uint64_t{points.size()});
  for (const Point& p : points) {
    append_canonical(bytes, p.x());
    append_canonical(bytes, p.y());
  }
}
void append_node(std::string& bytes, const NodeOfElement& node) {
  append_text(bytes, node.element);
  append_text(bytes, std::to_string(node.node));
}
void append_positions(std::string& bytes, const std::vector<std::size_t>& positions) {
  append_canonical(bytes, std::uint64_t{positions.size()});
  for (const std::size_t at : positions) append_canonical(bytes, std::uint64_t{at});
}

void append_stroke(std::string& bytes, const DrawnStroke& s) {
  append_text(bytes, s.element);
  append_points(bytes, s.points);
  append_canonical(bytes, s.width);
  append_canonical(bytes, std::uint64_t{s.tool});
  append_positions(bytes, s.nodes);
  append_positions(bytes, s.corners);
}
void append_area(std::string& bytes, const FilledArea& a) {
  append_text(bytes, a.element);
  append_text(bytes, canonical_bytes(Region{{a.area}}));
  append_text(bytes, a.choice.fill);
  append_canonical(bytes, a.choice.angle ? *a.choice.angle : 1e300);
  append_canonical(bytes, a.choice.outline ? std::uint64_t{*a.choice.outline} : std::uint64_t{2});
}

}  // namespace

Region drawn_area(const Drawing& drawing) {
  std::vector<Region> parts;
  for (const FilledArea& area : drawing.areas) parts.push_back({{area.area}});
  for (const DrawnStroke& stroke : drawing.strokes)
    if (stroke.tool)
      parts.push_back(swath({stroke.points}, stroke.width / 2, kChordError * stroke.width, Bound::inside));
  return unite(parts);
}

std::string canonical_bytes(const Drawing& drawing) {
  std::string bytes;
  append_canonical(bytes, std::uint64_t{drawing.strokes.size()});
  for (const DrawnStroke& stroke : drawing.strokes) append_stroke(bytes, stroke);
  append_canonical(bytes, std::uint64_t{drawing.areas.size()});
  for (const FilledArea& area : drawing.areas) append_area(bytes, area);
  append_points(bytes, drawing.start ? Polyline{*drawing.start} : Polyline{});
  append_canonical(bytes, std::uint64_t{drawing.connections.size()});
  for (const DrawnConnection& c : drawing.connections) {
    append_node(bytes, c.from);
    append_node(bytes, c.to);
    append_canonical(bytes, std::uint64_t{c.enforced});
  }
  append_canonical(bytes, std::uint64_t{drawing.curves.size()});
  for (const DrawnCurve& c : drawing.curves) {
    append_node(bytes, c.from);
    append_node(bytes, c.to);
    append_canonical(bytes, std::uint64_t{c.kind == DrawnCurve::Kind::bezier});
    append_points(bytes, c.points);
  }
  return bytes;
}

}  // namespace oxturn
