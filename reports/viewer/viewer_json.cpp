#include "reports/viewer/viewer_json.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "metrics/mission.hpp"

namespace oxturn {
namespace {

using Json = nlohmann::ordered_json;

/// Decimals of a coordinate: a millionth of the extent, 10 micrometres for a canvas of 20 m.
class Rounding {
 public:
  explicit Rounding(double extent) {
    const double digits = extent > 0 && std::isfinite(extent) ? 6 - std::floor(std::log10(extent)) : 6;
    scale_ = std::pow(10, std::clamp(digits, 0.0, 12.0));
  }
  double operator()(double value) const { return std::round(value * scale_) / scale_; }
  Json operator()(const Point& p) const { return Json::array({(*this)(p.x()), (*this)(p.y())}); }
  /// x, y, x, y, ...: half the size of pairs.
  Json operator()(const std::vector<Point>& points) const {
    Json flat = Json::array();
    for (const Point& p : points) {
      flat.push_back((*this)(p.x()));
      flat.push_back((*this)(p.y()));
    }
    return flat;
  }

 private:
  double scale_;
};

Json rings_of(const Polygon& polygon, const Rounding& rounded) {
  Json rings = Json::array({rounded(polygon.outer)});
  for (const Ring& hole : polygon.holes) rings.push_back(rounded(hole));
  return rings;
}

Json map_of(const Map& map, const Rounding& rounded) {
  Json polygons = Json::array();
  for (const Polygon& polygon : map.free.polygons) polygons.push_back(rings_of(polygon, rounded));
  return polygons;
}

Json drawing_of(const Drawing& drawing, const Rounding& rounded) {
  Json strokes = Json::array(), areas = Json::array();
  for (const DrawnStroke& stroke : drawing.strokes)
    strokes.push_back({{"element", stroke.element},
                       {"width", rounded(stroke.width)},
                       {"tool", stroke.tool},
                       {"nodes", stroke.nodes},
                       {"points", rounded(stroke.points)}});
  for (const FilledArea& filled : drawing.areas)
    areas.push_back({{"element", filled.element}, {"rings", rings_of(filled.area, rounded)}});
  return {{"sha256", drawing.sha256}, {"strokes", strokes}, {"areas", areas}};
}

/// A faulty planner's path may be anything; it has no times.
bool can_be_shown(const Path& path) {
  return std::ranges::all_of(path.legs, [](const Leg& leg) {
    return leg.points.size() >= 2 && std::ranges::all_of(leg.points, [](const Point& p) { return finite(p); });
  });
}

/// Every vertex with the time at which the robot is there.
Json legs_of(const Problem& problem, const Path& path, const Rounding& rounded) {
  const MissionClock clock(problem, path);
  Json legs = Json::array();
  double driven = 0;
  for (const Leg& leg : path.legs) {
    Json times = Json::array();
    for (std::size_t i = 0; i < leg.points.size(); ++i) {
      if (i > 0) driven += distance(leg.points[i - 1], leg.points[i]);
      times.push_back(std::round(clock.at(driven) * 1e3) / 1e3);
    }
    legs.push_back({{"tool", leg.tool},
                    {"reverse", leg.gear == Gear::reverse},
                    {"width", rounded(leg.width > 0 ? leg.width : problem.robot().tool_width)},
                    {"points", rounded(leg.points)},
                    {"times", std::move(times)}});
  }
  return legs;
}

Json traces_of(const std::vector<Trace>& traces, const Rounding& rounded) {
  Json all = Json::array();
  for (const Trace& trace : traces) {
    Json lines = Json::array();
    for (const Polyline& line : trace.lines) lines.push_back(rounded(line));
    all.push_back({{"name", trace.name}, {"lines", std::move(lines)}});
  }
  return all;
}

Json figures_of(const std::optional<Score>& score) {
  Json figures = Json::array();
  if (!score) return figures;
  for (const MetricValue& value : score->values)
    if (value.value && std::isfinite(*value.value)) figures.push_back(Json::array({value.name, *value.value}));
  return figures;
}

Json edits_of(const std::string& text) {
  if (text.empty()) return nullptr;
  Json edits = Json::parse(text, nullptr, false);
  if (!edits.is_object()) throw std::invalid_argument("viewer: the edits are not a JSON object");
  return edits;
}

std::string without_angle_brackets(const std::string& text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : text)
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  return out;
}

}  // namespace

std::string viewer_json(const ViewerData& data) {
  const Problem& problem = data.problem;
  const Map& map = problem.map();
  const Robot& robot = problem.robot();
  const Box box = bounding_box(map.free);
  const Rounding rounded(box.size().maxCoeff());
  Json out;
  out["file"] = data.drawing_file.empty() ? map.name : data.drawing_file;
  out["robot"] = {{"name", robot.name},
                  {"radius", robot.radius},
                  {"tool_width", robot.tool_width},
                  {"min_turn_radius", robot.min_turn_radius}};
  out["box"] = Json::array({rounded(box.low), rounded(box.high)});
  out["start"] = rounded(problem.start());
  out["map"] = map_of(map, rounded);
  out["drawing"] = map.drawing ? drawing_of(*map.drawing, rounded) : Json();
  out["legs"] = data.path && can_be_shown(*data.path) ? legs_of(problem, *data.path, rounded) : Json::array();
  out["traces"] = traces_of(data.traces, rounded);
  out["figures"] = figures_of(data.score);
  out["remarks"] = data.remarks;
  out["flaw"] = data.score ? data.score->flaw : "";
  out["edits"] = edits_of(data.edits);
  return without_angle_brackets(out.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace oxturn
