#include "algorithms/drawing/area_fill.hpp"

#include <algorithm>
#include <limits>
#include <optional>

#include "algorithms/drawing/followed_line.hpp"
#include "algorithms/drawing/outline_last.hpp"
#include "algorithms/drawing/uncovered_parts.hpp"
#include "algorithms/smoothing/strokes.hpp"
#include "base/throw_invalid.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/thinned.hpp"

namespace oxturn {
namespace {

constexpr double kChord = 1e-3;         // tool widths: error of the inset's arcs
constexpr double kLeastChord = 2.5e-4;  // the same in widths of the whole tool, for parts of it
// Parts of the tool for narrow areas: 5, 3 and 1 of 7 pins are 0.32, 0.16 and 0.04 m of 0.42 m wide.
constexpr double kPin = 0.04 / 0.42, kWidths[] = {1, 0.32 / 0.42, 0.16 / 0.42, kPin};
constexpr double kLeastPart = 1e-4;  // square tool widths: smaller parts of the inset are rounding
constexpr double kFilled = 0.985;    // of an area: less is filled up by narrower parts of the tool
constexpr double kLeastGain = 1e-4;  // of an area: parts that fill up less are left out
constexpr double kShortLap = 4;      // tool widths: longer thin parts are driven as planners do
// Tool widths: shorter thin tips are left out, of an area that is filled to 1.5 %; of others, until they are.
constexpr double kLeastTip = 0.5, kLeastNeededTips[] = {0.12, 0.08, 0.05, 0.03};
constexpr double kAbout = 2;             // tool widths that matter about a part of an area
constexpr double kRoughChord = 1e-2;     // tool widths
constexpr double kFillDeviation = 0.05;  // tool widths that a stroke may leave its lane where it bends too sharply
constexpr double kFillTurn = 0.5;        // radians, the same

double degrees(double radians) { return radians * 180 / kPi; }

/// The path without what leads to its first stroke.
std::vector<Leg> from_first_stroke(std::vector<Leg> legs) {
  const auto first = std::find_if(legs.begin(), legs.end(), [](const Leg& leg) { return leg.tool; });
  legs.erase(legs.begin(), first);
  while (!legs.empty() && !legs.back().tool) legs.pop_back();
  return legs;
}

double transits_m(const Path& path) {
  double sum = 0;
  for (const Leg& leg : path.legs)
    if (!leg.tool) sum += length(leg.points);
  return sum;
}

/// All but the smallest polygons, which have so many square metres in all.
Region largest_parts(Region region, double most_left) {
  std::ranges::stable_sort(region.polygons, {}, [](const Polygon& p) { return area(p); });
  std::size_t kept = 0;
  for (double left = 0; kept < region.polygons.size() && left <= most_left; ++kept) left += area(region.polygons[kept]);
  const auto first = region.polygons.begin();
  if (kept > 0) region.polygons.erase(first, first + static_cast<std::ptrdiff_t>(kept) - 1);
  return region;
}

/// `space` must outlive them.
FollowOptions follow_options(const Problem& problem, const CarSpace& space) {
  const double width = problem.robot().tool_width;
  return {.radius = space.radius(),
          .deviation = kFillDeviation * width,
          .turn = kFillTurn,
          .tool_width = width,
          .tolerance = problem.tolerance(),
          .chord_error = space.chord_error(),
          .free = [&space](const Polyline& line) { return space.free(line); }};
}

/// What the robot can follow of the path, in its order, with straight connections. Corners are rounded or cut off; what
/// that leaves uncovered comes first, so that nothing is finished about it yet.
std::vector<Leg> drivable_legs(const Path& path, const Problem& problem) {
  const CarSpace space(problem);
  const double width = problem.robot().tool_width;
  const FollowOptions follow = follow_options(problem, space);
  std::vector<Leg> strokes;
  for (Stroke& stroke : strokes_of(path, problem, space)) strokes.push_back({true, std::move(stroke.points)});
  const Region& all = problem.map().free;
  const Region rest =
      largest_parts(worthwhile(not_surely_covered(all, strokes, width), width), (1 - kFilled) * area(all));
  std::vector<Leg> legs;
  const auto add = [&](Polyline&& line) {
    if (!legs.empty()) legs.push_back({false, {legs.back().points.back(), line.front()}});
    legs.push_back({true, std::move(line)});
  };
  for (const Polyline& part : parts_near(work_lines(path), rest, width))
    for (Polyline& piece : followed_line(part, follow)) add(std::move(piece));
  for (Leg& stroke : strokes) add(std::move(stroke.points));
  return legs;
}

/// Whether a lap along the part's boundary covers all that the tool reaches from inside it: no disc of half the tool's
/// width fits.
bool is_small(const Polygon& part, double width) {
  return part.holes.empty() && area(part) < kPi / 4 * width * width && perimeter(Region{{part}}) < kShortLap * width;
}

DrawingElement lap(const FilledArea& area, const Polygon& part, double width) {
  Leg leg{.tool = true, .points = part.outer, .width = width};
  leg.points.push_back(leg.points.front());
  return {.name = area.element, .legs = {std::move(leg)}};
}

/// What of the area lies within that distance of the part.
Region about(const RingBoxes& area, const Polygon& part, double distance) {
  Box box = bounding_box(part.outer);
  box.grow(distance);
  return intersect(area.near(box), box_region(box.low, box.high));
}

/// Whether a tool whose centre runs over the part covers so many square metres of the rest.
bool gains(const Polygon& part, const RingBoxes& rest, double width, double least) {
  const Region reached = dilate({{part}}, width / 2, kRoughChord * width, Bound::inside);
  return area(reached) >= least && area(intersect(reached, rest.near(bounding_box(reached)))) >= least;
}

bool stays_in(const EdgeIndex& space, const Polyline& line) {
  for (std::size_t k = 1; k < line.size(); ++k)
    if (!space.contains(line[k - 1], line[k])) return false;
  return true;
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

const std::string& AreaFiller::name_of(const FillChoice& choice) const {
  return choice.fill.empty() ? options_.fill : choice.fill;
}

std::unique_ptr<CoveragePlanner> AreaFiller::planner(const FillChoice& choice) const {
  const std::string& fill = name_of(choice);
  if (fill == "spiral") return planners_.find("skeleton-spiral").make({}, planners_);
  if (fill == "contour") return planners_.find("contour").make({}, planners_);
  if (fill != "zigzag") throw_invalid("unknown fill '{}'; expected spiral, zigzag, contour or none", fill);
  Settings settings{{"outline", choice.outline.value_or(options_.outline)}};
  if (choice.angle)
    settings["sweep"] = std::string("given"), settings["angle"] = std::remainder(degrees(*choice.angle), 360);
  return planners_.find("zigzag").make(settings, planners_);
}

Problem AreaFiller::problem_of(const FilledArea& area, const Polygon& part, double width,
                               const RingBoxes* rings) const {
  Robot robot = filling_robot(width);
  robot.radius = 0;
  const Point inside = default_start(Map{area.element, {{part}}, "", ""}, robot);
  const Region map = rings ? about(*rings, part, kAbout * width) : Region{{area.area}};
  const Problem problem(Map{area.element, map, "drawing", ""}, filling_robot(width), inside);
  const bool whole = !rings && subtract(problem.configuration_space(), problem_.configuration_space()).empty();
  return whole ? problem : problem.restricted({{part}});
}

/// Where the robot comes from is not known yet: of zigzags from several points the one with the least transits.
Path AreaFiller::planned(const FillChoice& choice, const Problem& problem, const Polygon& part,
                         const Context& context) const {
  const Problem on_the_spot = problem.turning_on_the_spot();
  const auto from = [&](const Problem& p) {
    Context inner(context.seed(), context.seconds_left());
    return Path{from_first_stroke(planner(choice)->plan(p, inner).legs)};
  };
  Path best = from(on_the_spot);
  if (name_of(choice) != "zigzag") return best;
  for (const Point& direction : {Point(-1, 0), Point(1, 0), Point(0, -1), Point(0, 1)}) {
    if (!(transits_m(best) > problem.robot().tool_width)) break;
    const Point start = *std::ranges::max_element(part.outer, {}, [&](const Point& p) { return p.dot(direction); });
    if (!problem.walls().contains(start)) continue;
    Path path = from(on_the_spot.restricted(problem.configuration_space(), start));
    if (transits_m(path) < transits_m(best)) best = std::move(path);
  }
  return best;
}

DrawingElement AreaFiller::fill(const FilledArea& area, const Polygon& part, double width, const RingBoxes* rings,
                                const Context& context) const {
  if (is_small(part, width) && !(problem_.robot().min_turn_radius > 0)) return lap(area, part, width);
  const Problem problem = problem_of(area, part, width, rings);
  DrawingElement element{.name = area.element, .legs = {}};
  Path path = planned(area.choice, problem, part, context);
  const bool turns_on_the_spot = !(problem_.robot().min_turn_radius > 0);
  element.followed = !turns_on_the_spot;
  element.legs = turns_on_the_spot ? std::move(path.legs) : drivable_legs(path, problem);
  if (turns_on_the_spot && options_.outline_last) {
    const EdgeIndex space(Region{{part}});
    element.legs = oxturn::outline_last(std::move(element.legs), part.outer, width,
                                        [&](const Point& a, const Point& b) { return space.contains(a, b); });
  }
  for (Leg& leg : element.legs) {
    if (!leg.tool) continue;
    leg.width = width;
    Polyline fewer = thinned(leg.points, kLeastChord * problem_.robot().tool_width);
    if (stays_in(problem_.walls(), fewer)) leg.points = std::move(fewer);
  }
  return element;
}

std::vector<DrawingElement> AreaFiller::elements(const FilledArea& area, const Context& context) const {
  if (area.choice.fill == "none") return {};
  const Region whole{{area.area}};
  const RingBoxes rings(whole);
  const double all = oxturn::area(whole), tool_width = problem_.robot().tool_width;
  std::vector<DrawingElement> elements;
  Region rest = whole;
  std::optional<ThinLines> thin;
  if (options_.thin_lines) thin.emplace(area.area, kPin * tool_width);
  const double room = thin ? (1 + kRoughChord) * thin->largest_radius() : std::numeric_limits<double>::infinity();
  for (const double share : kWidths) {
    const double width = share * tool_width;
    if (inset(width) > room) continue;  // no part of the area: that need not be found out
    const bool near_rest = !elements.empty();
    const RingBoxes rest_rings(rest);
    std::vector<Leg> legs;
    const std::vector<Polygon> all_parts = parts(area, width, near_rest ? worthwhile(rest, width) : Region{});
    const bool alone = !near_rest && all_parts.size() == 1;
    for (const Polygon& part : all_parts) {
      if (near_rest && !gains(part, rest_rings, width, kLeastGain * all)) continue;
      DrawingElement element = fill(area, part, width, alone ? nullptr : &rings, context);
      if (element.legs.empty()) continue;
      legs.insert(legs.end(), element.legs.begin(), element.legs.end());
      elements.push_back(std::move(element));
    }
    if (!options_.complete && !elements.empty()) break;
    if (!legs.empty()) rest = not_surely_covered(rest, legs, tool_width);
    if (oxturn::area(rest) <= (1 - kFilled) * all) break;
  }
  if (thin) add_thin_lines(area, *thin, rest, elements);
  const auto outer = std::make_shared<const Ring>(area.area.outer);
  for (DrawingElement& element : elements) element.area = outer;
  return elements;
}

void AreaFiller::add_thin_lines(const FilledArea& area, const ThinLines& thin, const Region& rest,
                                std::vector<DrawingElement>& elements) const {
  const double tool_width = problem_.robot().tool_width, most_left = (1 - kFilled) * oxturn::area(Region{{area.area}});
  std::vector<Polyline> lines;
  const auto find = [&](double least) {
    lines = thin.lines(least * tool_width);
    std::erase_if(lines, [&](const Polyline& line) { return !stays_in(problem_.walls(), line); });
  };
  const auto enough = [&] {
    std::vector<Leg> legs;
    for (const Polyline& line : lines) legs.push_back({.tool = true, .points = line, .width = kPin * tool_width});
    return oxturn::area(not_surely_covered(rest, legs, tool_width)) <= most_left;
  };
  if (oxturn::area(rest) <= most_left) {
    find(kLeastTip);
  } else {
    for (const double least : kLeastNeededTips) {
      find(least);
      if (!options_.complete || enough()) break;
    }
  }
  for (Polyline& line : lines) elements.push_back(thin_element(area, std::move(line)));
}

DrawingElement AreaFiller::thin_element(const FilledArea& area, Polyline line) const {
  DrawingElement element{.name = area.element, .legs = {}};
  element.thin = true;
  element.followed = problem_.robot().min_turn_radius > 0;
  std::vector<Polyline> pieces;
  if (element.followed) {
    const CarSpace space(problem_);
    pieces = followed_line(line, follow_options(problem_, space));
  } else {
    pieces.push_back(std::move(line));
  }
  for (Polyline& piece : pieces) {
    if (!element.legs.empty()) element.legs.push_back({false, {piece.front(), piece.front()}});
    element.legs.push_back({.tool = true, .points = std::move(piece), .width = kPin * problem_.robot().tool_width});
  }
  return element;
}

/// Where the tool's centre may be, near the rest if there is one.
std::vector<Polygon> AreaFiller::parts(const FilledArea& area, double width, const Region& rest) const {
  const double w = filling_robot(width).tool_width;
  const double chord = std::max(kChord * w, kLeastChord * problem_.robot().tool_width);
  Region space = erode({{area.area}}, inset(width), chord, Bound::inside);
  const Box box = bounding_box(space);
  if (!space.empty() && !subtract(box_region(box.low, box.high), problem_.configuration_space()).empty())
    space = intersect(space, problem_.configuration_space());
  if (!rest.empty()) space = intersect(space, dilate(rest, width / 2, kRoughChord * width, Bound::inside));
  std::erase_if(space.polygons, [&](const Polygon& part) { return oxturn::area(part) < kLeastPart * w * w; });
  return space.polygons;
}

}  // namespace oxturn
