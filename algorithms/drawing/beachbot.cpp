// Draws: strokes and filled areas, in one path with as little driving between them as possible.
//
// Source      Vollprecht, Path Generation for a Mobile Drawing Robot, ETH Zurich 2014
// Model       drawing on a canvas (maps/drawing.hpp), offline, disc footprint
// Guarantee   drives every stroke once, with its own width, and covers of each filled area what the tool reaches
//             without leaving it
// Complexity  that of the fills, and of a tour over n elements (tour/solve_tour.hpp)
// Decisions   1. A map without a drawing is one filled area: what is to be covered of it.
//             2. A path begins where the robot is. It goes from there to the drawing's start, if it has one.
#include <utility>

#include "algorithms/drawing/area_fill.hpp"
#include "algorithms/drawing/containment.hpp"
#include "algorithms/drawing/drawing_tour.hpp"
#include "algorithms/transit/connector.hpp"

namespace oxturn {
namespace {

enum class Fill { spiral, zigzag, contour };
const Choices kFills{"spiral", "zigzag", "contour"};

struct Params {
  Fill fill = Fill::spiral;
  double line_distance = 0;
  double inset = 0;
  bool outline = true;
  Containment containment = Containment::strict;
};

FillOptions fill_options(const Params& p) {
  static constexpr const char* kNames[] = {"spiral", "zigzag", "contour"};
  return {kNames[static_cast<int>(p.fill)], p.line_distance, p.inset, p.outline};
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
    const Drawing drawing = drawing_of(problem.map());
    const std::vector<DrawingElement> elements = elements_of(problem, drawing, context);
    if (elements.empty()) throw Infeasible("the drawing has nothing that the robot can draw");
    std::vector<DrawingElement> all = elements;
    TourDemands demands = demands_of(drawing, all);
    const bool literal = p_.containment == Containment::literal;
    demands.contained = contained_elements(all, literal ? ContainmentTest::hull : ContainmentTest::overlay);
    demands.containment = p_.containment;
    trace_containment(all, demands, context);

    const Connector connector(problem);
    PathBuilder path(problem.start());
    if (drawing.start) path.drive(connector.path(path.at(), *drawing.start), false);
    const DrawingTour tour(all, demands, path.at(), problem.robot().min_turn_radius);
    for (const ElementVisit& visit : tour.solve(context)) {
      path.drive(connector.path(path.at(), entry_of(all[visit.element], visit)), false);
      for (const Leg& leg : driven(all[visit.element], visit)) path.drive(leg.points, leg.tool, leg.gear, leg.width);
    }
    return path.take();
  }

 private:
  std::vector<DrawingElement> elements_of(const Problem& problem, const Drawing& drawing, Context& context) const {
    std::vector<DrawingElement> elements = stroke_elements(drawing);
    context.trace("strokes", lines_of(elements, false));
    const AreaFiller filler(problem, fills_, fill_options(p_));
    for (const FilledArea& area : drawing.areas)
      for (DrawingElement& fill : filler.elements(area, context)) elements.push_back(std::move(fill));
    context.trace("fills", lines_of(elements, true));
    return elements;
  }

  static void trace_containment(const std::vector<DrawingElement>& elements, const TourDemands& demands,
                                Context& context) {
    std::vector<Polyline> lines;
    for (const auto& [outer, inner] : demands.contained) lines.push_back({elements[inner].first(), elements[outer].first()});
    context.trace("containment", std::move(lines));
  }

  Params p_;
  Planners fills_;  // planners that fill areas
};

const std::vector<Parameter<Params>>& parameters() {
  static const std::vector<Parameter<Params>> all{
      {"fill", &Params::fill, kFills, "of areas for which the drawing does not choose one"},
      {"line_distance", &Params::line_distance, Range{0, 1000}, "metres between lanes of a fill; 0: the tool width"},
      {"inset", &Params::inset, Range{0, 1000}, "metres that fills keep from an area's boundary; 0: half the tool width"},
      {"outline", &Params::outline, "zigzag fills end with a lap along the boundary"},
      {"containment", &Params::containment, Choices{"strict", "literal"},
       "strict: elements inside another one are drawn before it; literal: only no direct connection leads inwards"}};
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
  info.published = {{"containment", std::string("literal")}, {"line_distance", 0.25}, {"inset", 0.3}};
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
