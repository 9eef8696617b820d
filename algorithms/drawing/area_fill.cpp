#include "algorithms/drawing/area_fill.hpp"

#include <algorithm>

#include "base/throw_invalid.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"

namespace oxturn {
namespace {

constexpr double kChord = 1e-3;      // tool widths: error of the inset's arcs
constexpr double kLeastPart = 1e-4;  // square tool widths: smaller parts of the inset are rounding

double degrees(double radians) { return radians * 180 / kPi; }

/// The path without what leads to its first stroke.
std::vector<Leg> from_first_stroke(std::vector<Leg> legs) {
  const auto first = std::find_if(legs.begin(), legs.end(), [](const Leg& leg) { return leg.tool; });
  legs.erase(legs.begin(), first);
  while (!legs.empty() && !legs.back().tool) legs.pop_back();
  return legs;
}

}  // namespace

Robot AreaFiller::filling_robot() const {
  Robot robot = problem_.robot();
  robot.radius = inset();
  robot.min_turn_radius = 0;
  robot.footprint.clear();
  if (options_.line_distance > 0) robot.tool_width = std::min(robot.tool_width, options_.line_distance);
  return robot;
}

double AreaFiller::inset() const { return options_.inset > 0 ? options_.inset : problem_.robot().tool_width / 2; }

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

DrawingElement AreaFiller::fill(const FilledArea& area, const Polygon& part, const Context& context) const {
  Robot robot = filling_robot();
  robot.radius = 0;
  const Point inside = default_start(Map{area.element, {{part}}, "", ""}, robot);
  Problem problem(Map{area.element, {{area.area}}, "drawing", ""}, filling_robot(), inside);
  if (!subtract(problem.configuration_space(), problem_.configuration_space()).empty())
    problem = problem.restricted({{part}});
  Context inner(context.seed(), context.seconds_left());
  DrawingElement element{.name = area.element, .legs = {}, .area = area.area.outer};
  element.legs = from_first_stroke(planner(area.choice)->plan(problem, inner).legs);
  for (Leg& leg : element.legs)
    if (leg.tool) leg.width = problem_.robot().tool_width;
  return element;
}

std::vector<DrawingElement> AreaFiller::elements(const FilledArea& area, const Context& context) const {
  const double w = filling_robot().tool_width;
  if (area.choice.fill == "none") return {};
  const Region space =
      intersect(erode({{area.area}}, inset(), kChord * w, Bound::inside), problem_.configuration_space());
  std::vector<DrawingElement> elements;
  for (const Polygon& part : space.polygons) {
    if (oxturn::area(part) < kLeastPart * w * w) continue;
    DrawingElement element = fill(area, part, context);
    if (!element.legs.empty()) elements.push_back(std::move(element));
  }
  return elements;
}

}  // namespace oxturn
