// Draws: strokes and filled areas, in one path with as little driving between them as possible.
//
// Source      Vollprecht, Path Generation for a Mobile Drawing Robot, ETH Zurich 2014
// Model       drawing on a canvas (maps/drawing.hpp), offline, disc footprint
// Guarantee   drives every stroke once, with its own width, and covers of each filled area what the tool reaches
//             without leaving it; drives over finished work only where no other path exists
// Complexity  that of the fills, and of a tour over n elements (tour/solve_tour.hpp)
// Decisions   1. A map without a drawing is one filled area: what is to be covered of it.
//             2. A path begins where the robot is. It goes from there to the drawing's start, if it has one.
//             3. For a robot with a least turning radius fills become strokes that it can follow
//                (smoothing/strokes.hpp); without a drawing they are also ordered as for any planner (drivable.hpp).
//             4. Strokes are drawn as they are. Each point where the path turns more sharply than the radius is listed.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <utility>

#include "algorithms/drawing/area_fill.hpp"
#include "algorithms/drawing/containment.hpp"
#include "algorithms/drawing/fill_order.hpp"
#include "algorithms/drawing/followed_strokes.hpp"
#include "algorithms/drawing/loose_strokes.hpp"
#include "algorithms/drawing/order_driver.hpp"
#include "algorithms/smoothing/drivable.hpp"
#include "algorithms/transit/connector.hpp"
#include "geometry/bends.hpp"
#include "geometry/point_outside.hpp"

namespace oxturn {
namespace {

// Tool widths about the ends of a transit in which nothing counts as driving over finished work: half a width, and a
// little more, so that the round end of a stroke as wide as the tool leaves no ring about the robot.
constexpr double kExempt = 0.52;
constexpr double kDeviation = 0.02;  // tool widths that a stroke may be left where it bends too sharply

enum class Fill { spiral, zigzag, contour };
enum class Complete { automatic, on, off };
enum class ThinAreas { line, skip };
const Choices kFills{"spiral", "zigzag", "contour"};

struct Params {
  Fill fill = Fill::spiral;
  double line_distance = 0;
  double inset = 0;
  bool outline = true;
  Complete complete = Complete::automatic;
  ThinAreas thin_areas = ThinAreas::line;
  Containment containment = Containment::strict;
  FinishedRule finished = FinishedRule::around;
  double keep_off = -1;
  CornerRule corner = CornerRule::automatic;
  double round_radius = 0;
  ConnectionKind connection = ConnectionKind::spiro;
};

FillOptions fill_options(const Params& p) {
  static constexpr const char* kNames[] = {"spiral", "zigzag", "contour"};
  return {kNames[static_cast<int>(p.fill)], p.line_distance, p.inset, p.outline, p.finished == FinishedRule::around};
}

/// Decision 1.
Drawing drawing_of(const Map& map) {
  if (map.drawing) return *map.drawing;
  Drawing drawing;
  for (const Polygon& part : (map.target_area ? *map.target_area : map.free).polygons)
    drawing.areas.push_back({.element = "target", .area = part, .choice = {}});
  return drawing;
}

std::vector<Polyline> lines_of(const std::vector<DrawingElement>& elements, bool fills) {
  std::vector<Polyline> lines;
  for (const DrawingElement& e : elements)
    if (e.is_fill() == fills)
      for (const Leg& leg : e.legs) lines.push_back(leg.points);
  return lines;
}

class Beachbot final : public CoveragePlanner {
 public:
  Beachbot(Params p, const Planners& planners)
      : p_(p),
        fills_("planner", {planners.find("skeleton-spiral"), planners.find("zigzag"), planners.find("contour")}) {}

  Path plan(const Problem& problem, Context& context) const override {
    if (problem.map().drawing || !(problem.robot().min_turn_radius > 0)) return drawn(problem, context);
    Context inner(context.seed(), context.seconds_left());
    return drivable(problem, drawn(problem.turning_on_the_spot(), inner), context);
  }

 private:
  Path drawn(const Problem& problem, Context& context) const {
    const Drawing drawing = drawing_of(problem.map());
    std::vector<DrawingElement> elements = elements_of(problem, drawing, context);
    if (elements.empty()) throw Infeasible("the drawing has nothing that the robot can draw");
    TourDemands demands = demands_of(drawing, elements);
    PortCurves curves = curves_of(drawing, demands);
    const bool literal = p_.containment == Containment::literal;
    demands.contained = contained_elements(elements, literal ? ContainmentTest::hull : ContainmentTest::overlay);
    if (!literal)
      for (const auto& pair : narrower_fills(elements)) demands.contained.push_back(pair);
    demands.containment = p_.containment;
    trace_containment(elements, demands, context);

    PathBuilder path(problem.start());
    if (drawing.start) path.drive(Connector(problem).path(path.at(), *drawing.start), false);
    const double radius = p_.round_radius > 0 ? p_.round_radius : problem.robot().min_turn_radius;
    if (radius > 0 && p_.corner == CornerRule::automatic)
      follow_strokes(elements, demands, curves, follow_options(problem, radius));
    const double keep_off = p_.keep_off < 0 ? problem.robot().radius : p_.keep_off;
    if (radius > 0 && p_.finished == FinishedRule::around) order_fills(elements, demands, problem, radius, keep_off);
    FinishedWork work(pieces_of(elements).pieces, kExempt * problem.robot().tool_width);
    std::optional<SmoothTransits> smooth;
    if (radius > 0) smooth.emplace(problem, work, smooth_options(radius, keep_off));
    TransitRouter router(problem, work, keep_off, smooth ? &*smooth : nullptr);
    DrawingTour tour(elements, demands, path.at(), radius);
    PricedOrder priced(elements, path.at(), p_.finished, router, work);
    DrivenOrder order = priced.search(tour, context);
    context.record("straight_tour_m", priced.straight_m());
    if (radius > 0 && p_.finished == FinishedRule::around) {
      LooseStrokes loose(elements, demands, curves);
      const DrawingTour loose_tour(loose.elements, loose.demands, path.at(), radius);
      PricedOrder strokes(loose.elements, path.at(), p_.finished, router, work);
      order = strokes.improved(strokes.driven(loose.order(order.order)), loose_tour, context);
      elements = std::move(loose.elements);
      curves = std::move(loose.curves);
    }
    std::optional<LastDetours> last;
    if (p_.finished == FinishedRule::around) last.emplace(problem, work, radius);
    OrderDriver driver(elements, router, work, smooth ? &*smooth : nullptr,
                       {p_.corner, radius, kDeviation * problem.robot().tool_width}, last ? &*last : nullptr);
    driver.drive(order, curves, path, context);
    report(driver, curves, context);
    Path result = path.take();
    report_bends(result, problem, radius, context);
    return result;
  }

  std::vector<DrawingElement> elements_of(const Problem& problem, const Drawing& drawing, Context& context) const {
    std::vector<DrawingElement> elements = stroke_elements(drawing);
    check_inside(problem, drawing);
    context.trace("strokes", lines_of(elements, false));
    FillOptions options = fill_options(p_);
    // Of other maps all is covered with the whole tool.
    options.complete = problem.map().drawing && completes(problem.robot());
    options.thin_lines = problem.map().drawing && p_.thin_areas == ThinAreas::line;
    const AreaFiller filler(problem, fills_, options);
    std::vector<Polyline> narrow, thin;
    std::size_t as_lines = 0;
    for (const FilledArea& area : drawing.areas) {
      std::vector<DrawingElement> fills = filler.elements(area, context);
      if (fills.empty() && area.choice.fill != "none") narrow.push_back(area.area.outer);
      for (const DrawingElement& fill : fills)
        if (fill.thin)
          for (const Leg& leg : fill.legs) thin.push_back(leg.points);
      as_lines += std::ranges::any_of(fills, &DrawingElement::thin);
      std::move(fills.begin(), fills.end(), std::back_inserter(elements));
    }
    context.trace("fills", lines_of(elements, true));
    if (!narrow.empty()) context.record("areas_too_narrow", static_cast<double>(narrow.size()));
    context.trace("areas too narrow", std::move(narrow));
    context.record("areas_with_thin_lines", static_cast<double>(as_lines));
    if (!thin.empty()) context.trace("thin areas", std::move(thin));
    return elements;
  }

  /// Laps of fills in the order in which their loops cross the least of each other.
  /// Not of those that a person connected: their ends must stay.
  void order_fills(std::vector<DrawingElement>& elements, const TourDemands& demands, const Problem& problem,
                   double radius, double keep_off) const {
    const auto price = [&](const DrawingElement& element) -> InnerPrice {
      const std::vector<DrawingElement> alone{element};
      FinishedWork work(pieces_of(alone).pieces, kExempt * problem.robot().tool_width);
      const SmoothTransits smooth(problem, work, smooth_options(radius, keep_off));
      TransitRouter router(problem, work, keep_off, &smooth);
      const DrivenOrder driven = PricedOrder(alone, element.first(), p_.finished, router, work).driven({{}});
      return {driven.crossing_m, driven.length_m};
    };
    std::vector<bool> named(elements.size(), false);
    for (const auto* connections : {&demands.joined, &demands.deleted})
      for (const auto& [a, b] : *connections) named[a.element] = named[b.element] = true;
    for (std::size_t e = 0; e < elements.size(); ++e)
      if (elements[e].is_fill() && elements[e].legs.size() > 1 && !named[e])
        elements[e] = best_order(elements[e], problem.robot().tool_width, price);
  }

  /// Strokes and the start must be where the robot can drive.
  static void check_inside(const Problem& problem, const Drawing& drawing) {
    if (drawing.start && !nearly_contains(problem.walls(), *drawing.start, problem.tolerance()))
      throw Infeasible(fmt::format("the drawing's start {} is outside configuration space", to_text(*drawing.start)));
    for (const DrawnStroke& stroke : drawing.strokes)
      for (std::size_t k = 1; k < stroke.points.size(); ++k)
        if (const auto p = point_outside(problem.walls(), stroke.points[k - 1], stroke.points[k], problem.tolerance()))
          throw Infeasible(
              fmt::format("stroke '{}'{} leaves configuration space at {}: less than the robot's radius of "
                          "{} m from the boundary; expected a larger margin (--margin)",
                          stroke.element, stroke.line > 0 ? fmt::format(" (line {})", stroke.line) : "", to_text(*p),
                          problem.robot().radius));
  }

  static void trace_containment(const std::vector<DrawingElement>& elements, const TourDemands& demands,
                                Context& context) {
    std::vector<Polyline> lines;
    for (const auto& [outer, inner] : demands.contained)
      lines.push_back({elements[inner].first(), elements[outer].first()});
    context.trace("containment", std::move(lines));
  }

  SmoothTransits::Options smooth_options(double radius, double keep_off) const {
    return {.radius = radius,
            .keep_off = keep_off,
            .first = p_.connection,
            .avoid = p_.finished == FinishedRule::around,
            .literal = p_.finished == FinishedRule::ignore && p_.connection == ConnectionKind::spiro};
  }

  bool completes(const Robot& robot) const {
    return p_.complete == Complete::automatic ? !(robot.min_turn_radius > 0) : p_.complete == Complete::on;
  }

  static FollowOptions follow_options(const Problem& problem, double radius) {
    const double width = problem.robot().tool_width;
    const auto free = [&problem](const Polyline& piece) {
      for (std::size_t k = 1; k < piece.size(); ++k)
        if (!problem.walls().contains(piece[k - 1], piece[k])) return false;
      return true;
    };
    return {.radius = radius,
            .deviation = kDeviation * width,
            .tool_width = width,
            .tolerance = problem.tolerance(),
            .chord_error = kChordError * width,
            .free = free};
  }

  static void report(const OrderDriver& driver, const PortCurves& curves, Context& context) {
    std::map<LastDetour::End, std::vector<Polyline>> over;
    double metres = 0;
    for (const auto& [transit, why] : driver.crossing())
      metres += transit.crossing_m, over[why].push_back(transit.path);
    context.record("over_finished_m", metres);
    context.record("transits_over_finished", static_cast<double>(driver.crossing().size()));
    context.record("last_detours", static_cast<double>(driver.last_detours()));
    if (!curves.empty()) context.record("curves_obeyed", static_cast<double>(driver.curves_used()));
    context.trace("transits", driver.transits());
    for (auto& [why, paths] : over) context.trace(trace_of_crossing(why), std::move(paths));
  }

  /// Where the path turns more sharply than the radius: corners of strokes, curves of a person, narrow parts.
  static void report_bends(const Path& path, const Problem& problem, double radius, Context& context) {
    std::vector<Polyline> sharp;
    if (radius > 0)
      for (const Bend& bend : bends(path, problem.tolerance(), problem.robot().tool_width))
        if (too_sharp(bend, radius)) sharp.push_back({bend.at, bend.at});
    context.record("sharp_bends", static_cast<double>(sharp.size()));
    context.trace("sharp bends", std::move(sharp));
  }

  Params p_;
  Planners fills_;  // planners that fill areas
};

const std::vector<Parameter<Params>>& parameters() {
  static const std::vector<Parameter<Params>> all{
      {"fill", &Params::fill, kFills, "of areas for which the drawing does not choose one"},
      {"line_distance", &Params::line_distance, Range{0, 1000}, "metres between lanes of a fill; 0: the tool width"},
      {"inset", &Params::inset, Range{0, 1000},
       "metres that fills keep from an area's boundary; 0: half the tool width"},
      {"outline", &Params::outline, "zigzag fills end with a lap along the boundary"},
      {"complete", &Params::complete, Choices{"automatic", "on", "off"},
       "on: 5, 3 and 1 of the 7 pins fill what the whole tool leaves of an area; off: only areas too narrow for it; "
       "automatic: on for robots that turn on the spot, as others need a loop for each of the many short lanes"},
      {"thin_areas", &Params::thin_areas, Choices{"line", "skip"},
       "where an area is narrower than one pin: draw a line one pin wide along its middle, or nothing"},
      {"containment", &Params::containment, Choices{"strict", "literal"},
       "strict: elements inside another one are drawn before it; literal: only no direct connection leads inwards"},
      {"finished", &Params::finished, Choices{"around", "weight", "ignore"},
       "transits go round what is drawn; weight: tours with connections over it are changed; ignore: neither"},
      {"keep_off", &Params::keep_off, Range{-1, 1000},
       "metres that the robot's centre keeps from what is drawn, where it can; below 0: the robot's radius"},
      {"corner", &Params::corner, Choices{"automatic", "inside", "outside", "stop", "literal"},
       "how a radius is kept at corners of strokes; automatic: inside if that deviates little, else outside"},
      {"round_radius", &Params::round_radius, Range{0, 1000},
       "metres: radius of connections and corners; 0: the robot's least turning radius"},
      {"connection", &Params::connection, Choices{"spiro", "bezier", "clothoid", "dubins"},
       "the kind of curve that is tried first"}};
  return all;
}

}  // namespace

PlannerInfo beachbot() {
  PlannerInfo info;
  info.covers_target_areas = true;
  info.name = "beachbot";
  info.family = "drawing";
  info.title = "strokes and filled areas of a drawing";
  info.citation = "BeachBot (Vollprecht 2014)";
  info.capabilities = {Capability::holes, Capability::curvature};
  info.guarantee = "drives every stroke once, with its width, and fills what the tool reaches of each area";
  info.parameters = infos_of(parameters());
  info.published = {{"containment", std::string("literal")},
                    {"finished", std::string("ignore")},
                    {"corner", std::string("literal")},
                    {"complete", std::string("off")},
                    {"thin_areas", std::string("skip")},
                    {"line_distance", 0.25},
                    {"inset", 0.3},
                    {"round_radius", 0.5}};
  info.parameters.push_back(variant_parameter(info.published));
  info.make = [info](const Settings& settings, const Planners& planners) {
    const std::string owner = "planner 'beachbot'";
    Settings all = with_variant(info, checked(owner, info.parameters, settings));
    all.erase("variant");
    return std::make_unique<Beachbot>(with_settings<Params>(owner, parameters(), all), planners);
  };
  return info;
}

}  // namespace oxturn
