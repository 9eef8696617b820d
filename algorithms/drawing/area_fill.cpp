#include "algorithms/drawing/area_fill.hpp"

#include <algorithm>

#include "algorithms/smoothing/strokes.hpp"
#include "base/throw_invalid.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"

namespace oxturn {
namespace {

constexpr double kChord = 1e-3;  // tool widths: error of the inset's arcs
// Parts of the tool for narrow areas: 5, 3 and 1 of 7 pins are 0.32, 0.16 and 0.04 m of 0.42 m wide.
constexpr double kWidths[] = {1, 0.32 / 0.42, 0.16 / 0.42, 0.04 / 0.42};
constexpr double kLeastPart = 1e-4;  // square tool widths: smaller parts of the inset are rounding

double degrees(double radians) { return radians * 180 / kPi; }

/// The path without what leads to its first stroke.
std::vector<Leg> from_first_stroke(std::vector<Leg> legs) {
  const auto first = std::find_if(legs.begin(), legs.end(), [](const Leg& leg) { return leg.tool; });
  legs.erase(legs.begin(), first);
  while (!legs.empty() && !legs.back().tool) legs.pop_back();
  return legs;
}

/// What the robot can follow of the path, in its order, with straight connections.
std::vector<Leg> drivable_legs(const Path& path, const Problem& problem) {
  std::vector<Leg> legs;
  for (Stroke& stroke : strokes_of(path, problem, CarSpace(problem))) {
    if (!legs.empty()) legs.push_back({false, {legs.back().points.back(), stroke.points.front()}});
    legs.push_back({true, std::move(stroke.points)});
  }
  return legs;
}

}  // namespace

Robot AreaFiller::filling_robot(double width) const {
  Robot robot = problem_.robot();
  robot.radius = inset(width);
  robot.tool_width = width;
  robot.footprint.clear();
  if (options_.line_distance > 0) robot.tool_width = std::min(robot.tool_width, options_.line_distance);
  return robot;
}

double AreaFiller::inset(double width) const {
  return options_.inset > 0 && width == problem_.robot().tool_width ? options_.inset : width / 2;
}

std::unique_ptr<CoveragePlanner> AreaFiller::planner(const FillChoice& choice) const {
  const std::string& fill = choice.fill.empty() ? options_.fill : choice.fill;
  if (fill == "spiral") return planners_.find("skeleton-spiral").make({}, planners_);
  if (fill == "contour") return planners_.find("contour").make({}, planners_);
  if (fill != "zigzag") throw_invalid("unknown fill '{}'; expected spiral, zigzag, contour or none", fill);
  Settings settings{{"outline", choice.outline.value_or(options_.outline)}};
  if (choice.angle)
    settings["sweep"] = std::string("given"), settings["angle"] = std::remainder(degrees(*choice.angle), 360);
  return planners_.find("zigzag").make(settings, planners_);
}

DrawingElement AreaFiller::fill(const FilledArea& area, const Polygon& part, double width,
                                const Context& context) const {
  Robot robot = filling_robot(width);
  robot.radius = 0;
  const Point inside = default_start(Map{area.element, {{part}}, "", ""}, robot);
  Problem problem(Map{area.element, {{area.area}}, "drawing", ""}, filling_robot(width), inside);
  if (!subtract(problem.configuration_space(), problem_.configuration_space()).empty())
    problem = problem.restricted({{part}});
  Context inner(context.seed(), context.seconds_left());
  DrawingElement element{.name = area.element, .legs = {}, .area = area.area.outer};
  Path path = planner(area.choice)->plan(problem.turning_on_the_spot(), inner);
  const bool turns_on_the_spot = !(problem_.robot().min_turn_radius > 0);
  element.legs = turns_on_the_spot ? from_first_stroke(std::move(path.legs)) : drivable_legs(path, problem);
  for (Leg& leg : element.legs)
    if (leg.tool) leg.width = width;
  return element;
}

std::vector<DrawingElement> AreaFiller::elements(const FilledArea& area, const Context& context) const {
  if (area.choice.fill == "none") return {};
  for (const double share : kWidths)
    if (auto fills = elements(area, share * problem_.robot().tool_width, context); !fills.empty()) return fills;
  return {};
}

std::vector<DrawingElement> AreaFiller::elements(const FilledArea& area, double width, const Context& context) const {
  const double w = filling_robot(width).tool_width;
  const Region space =
      intersect(erode({{area.area}}, inset(width), kChord * w, Bound::inside), problem_.configuration_space());
  std::vector<DrawingElement> elements;
  for (const Polygon& part : space.polygons) {
    if (oxturn::area(part) < kLeastPart * w * w) continue;
    DrawingElement element = fill(area, part, width, context);
    if (!element.legs.empty()) elements.push_back(std::move(element));
  }
  return elements;
}

}  // namespace oxturn
