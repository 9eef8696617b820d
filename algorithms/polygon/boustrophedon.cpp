// Back-and-forth lanes in cells without critical points inside, joined by transit.
//
// Source      Choset and Pignon, "Coverage Path Planning: The Boustrophedon Cellular Decomposition", FSR 1997;
//             Choset, Autonomous Robots 9, 2000
// Model       polygons with holes, offline, disc or polygonal footprint
// Guarantee   with the whole `outline`: covers the whole target (along traced walls but for 0.0005 of it, see
//             straightened_space in outline.hpp). Let C be configuration space, w the tool width, R the points of
//             C at least w/2 from its boundary. Driving the boundary covers all points within w/2 of it, inside and
//             outside C. A point p of R lies in a slab no wider than w with centre line x. The point (x, p.y) is no
//             farther from p than p from the boundary, so it lies in C, on the slab's lane, and covers p (lanes.hpp).
//             With `outline = needed`: see needed_outline.hpp. Without, slanted ends of lanes and a seam along the
//             walls stay uncovered, as in the paper.
// Complexity  n vertices, m lanes, k crossings of walls with slab lines: O((n + k) log n) for the lanes (up to 16 times
//             that to find the direction), about O(m log m) steps and path searches for the order
// Decisions   1. Lanes are projections of whole slabs, not samples on a line. The rings of the outline are inserted
//                where the path passes next to them, so no wall needs a second visit.
//             2. cells = slab (default): one set of slabs over the whole map; a cell is a longest run of lanes that
//                follow each other one to one. Where two critical points are nearer than w, the exact cells need an
//                extra lane each; slabs never do. On maps traced from laser scans that is most of the length. A
//                component of R that is no wider than a slab takes one lane of its own, and so does a corridor across
//                the slabs (lanes/corridors.hpp).
//             3. cells = exact: the paper's cells (of R with `outline`, of C without), with evenly spaced lanes in
//                each. A lane whose part of the cell lies under lanes placed before is omitted.
//             4. sweep = best counts a turn as 2 w and a break between cells as 4 w.
//             5. Links longer than 3 w between lanes of a cell are transit.
//             6. Planner `trapezoid` is the older decomposition (Latombe 1991), which cuts at every vertex; all else is
//                the same. Cells narrower than w are joined with their neighbours, else round corners would be cells.
#include <algorithm>
#include <numeric>

#include "algorithms/lanes/headland.hpp"
#include "algorithms/lanes/lane_direction.hpp"
#include "algorithms/lanes/lanes.hpp"
#include "algorithms/lanes/outline.hpp"
#include "algorithms/polygon/cell_circuit.hpp"
#include "algorithms/polygon/cell_directions.hpp"
#include "algorithms/polygon/needed_outline.hpp"
#include "algorithms/polygon/slab_strips.hpp"
#include "geometry/overlay/boolean.hpp"

namespace oxturn {
namespace {

enum class Decomposition { automatic, slab, exact, trapezoid };
enum class Order { improved, nearest, depth_first, gtsp, postman };

struct Params : Headland, OutlineChoice {
  LaneDirection sweep = LaneDirection::best;
  double angle = 0;
  Decomposition cells = Decomposition::automatic;
  double spacing = 1;
  Order order = Order::improved;
  TourMeasure objective = TourMeasure::length;

  void check() const {
    if (order == Order::postman && cells == Decomposition::slab)
      throw std::invalid_argument(
          "planner 'boustrophedon': order 'postman' needs cells with two ends; set cells to 'exact'");
  }
};

struct TrapezoidParams : Params {
  TrapezoidParams() { cells = Decomposition::trapezoid; }
};

using Cells = std::vector<BoustrophedonCell>;

/// The strips that have lanes, with the neighbours that their cells have.
std::vector<Strip> without_empty(std::vector<Strip> of_cell, const Cells& cells) {
  std::vector<std::size_t> index(cells.size(), ClippedLanes::kNone);
  std::vector<Strip> strips;
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (!of_cell[c].lanes.empty()) {
      index[c] = strips.size();
      strips.push_back(std::move(of_cell[c]));
    }
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const std::size_t o : cells[c].neighbours)
      if (index[c] != ClippedLanes::kNone && index[o] != ClippedLanes::kNone)
        strips[index[c]].neighbours.push_back(index[o]);
  return strips;
}

/// For pictures.
Polyline closed_outline(const BoustrophedonCell& cell, const LaneFrame& frame) {
  Polyline line = outline(cell, frame);
  if (!line.empty()) line.push_back(line.front());
  return line;
}

/// Cells with directions of their own, in the order of the tour that chose them.
std::vector<Strip> directed_strips(const Region& region, const Params& p, const Problem& problem, LaneFit fit,
                                   Context& context) {
  CellDirections options{.spacing = p.spacing * problem.robot().tool_width, .fit = fit, .objective = p.objective};
  if (p.sweep == LaneDirection::given) options.cut = p.angle;
  const std::vector<DirectedCell> cells = directed_cells(problem, region, options, context);
  if (context.wants_traces()) {
    std::vector<Polyline> outlines;
    outlines.reserve(cells.size());
    for (const DirectedCell& c : cells) outlines.push_back(closed_outline(c.cell, LaneFrame(c.degrees)));
    context.trace("cells", std::move(outlines));
  }
  return strips_of(problem, cells, options, context);
}

std::vector<Strip> strips_in(const Region& region, const Params& p, const Problem& problem, Context& context) {
  if (region.empty()) return {};
  const LaneFit fit = p.outline != OutlineExtent::off || p.headland > 0 ? LaneFit::fitted : LaneFit::spaced;
  if (p.order == Order::gtsp && p.cells != Decomposition::slab)
    return directed_strips(region, p, problem, fit, context);
  const double w = problem.robot().tool_width, spacing = p.spacing * w;
  const double direction = p.sweep == LaneDirection::given ? p.angle : best_lane_direction(region, spacing);
  const bool slabs =
      p.cells == Decomposition::slab || (p.cells == Decomposition::automatic && p.order != Order::postman);
  if (slabs) return slab_strips(region, direction, spacing, problem);
  const LaneField field(problem, direction, spacing);
  // United first: rings that touch may cross by rounding once rotated, which the exact plane sweep rejects.
  const Region clean = unite({field.frame.to_frame(region)});
  Cells cells = p.cells == Decomposition::trapezoid ? trapezoid_cells(clean, w) : boustrophedon_cells(clean);
  if (p.order == Order::postman) cells = cell_circuit(cells, field.frame.to_frame(problem.start()));
  std::vector<Strip> strips = cell_strips(field, cells, fit, context);
  if (context.wants_traces()) {
    std::vector<Polyline> outlines;
    for (const BoustrophedonCell& cell : cells) outlines.push_back(closed_outline(cell, field.frame));
    context.trace("cells", std::move(outlines));
  }
  return without_empty(std::move(strips), cells);
}

StripOrder strip_order(Order order) {
  switch (order) {
    case Order::improved:
      return StripOrder::improved;
    case Order::nearest:
      return StripOrder::nearest;
    case Order::depth_first:
      return StripOrder::depth_first;
    case Order::gtsp:
      return StripOrder::generalised;
    case Order::postman:
      return StripOrder::given;
  }
  return StripOrder::improved;
}

/// All lanes in one direction, so that what one set leaves uncovered is known for the next.
Path plan_needed(Params p, Path whole, const Problem& problem, Context& context) {
  if (p.sweep == LaneDirection::best) {
    p.angle = best_lane_direction(problem.configuration_space(), p.spacing * problem.robot().tool_width);
    p.sweep = LaneDirection::given;
  }
  const auto strips = [&](const Region& region) { return strips_in(region, p, problem, context); };
  return drive_needed_outline(problem, p.coverage, std::move(whole), strips, strip_order(p.order), context);
}

Path plan(const Params& p, const Problem& problem, Context& context) {
  const double w = problem.robot().tool_width;
  const auto strips_deeper_than = [&](double depth) {
    return strips_in(lane_region(problem, depth, w / 50), p, problem, context);
  };
  if (p.headland > 0) return drive_with_headland(problem, p, strips_deeper_than, strip_order(p.order), context);
  if (p.outline == OutlineExtent::needed)
    return plan_needed(p, plan(with_whole_outline(p), problem, context), problem, context);
  const bool whole = p.outline == OutlineExtent::whole;
  const Region region = whole ? lane_region(problem, w / 2, w / 50) : problem.configuration_space();
  return drive_strips_and_walls(problem, strips_in(region, p, problem, context), strip_order(p.order), whole, context);
}

Path plan_trapezoids(const TrapezoidParams& p, const Problem& problem, Context& context) {
  return plan(p, problem, context);
}

/// The parameters of both planners, less `cells`.
template <class P>
std::vector<Parameter<P>> parameters(std::vector<Parameter<P>> own, Parameter<P> order) {
  std::vector<Parameter<P>> all{
      {"sweep", &P::sweep, Choices{"best", "given"}, "lane direction: the cheapest of up to 16, or `angle`"},
      {"angle", &P::angle, Range{-360, 360}, "degrees; direction of the lanes if sweep is given"}};
  all = with_outline_choice<P>(std::move(all), ", with links along the walls, as in the paper");
  all.insert(all.end(), own.begin(), own.end());
  all.push_back({"spacing", &P::spacing, Range{0.1, 1}, "distance of lanes, in tool widths"});
  all.push_back(std::move(order));
  return with_headland<P>(std::move(all));
}

}  // namespace

PlannerInfo boustrophedon() {
  return describe<Params, plan>(
      {.name = "boustrophedon",
       .family = "polygon",
       .title = "Boustrophedon decomposition",
       .citation = "Choset, Pignon 1998",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "covers the whole target (unless outline = false, or coverage is below 1; along traced walls but "
                    "for 0.0005 of it)",
       .promise = Promise::target,
       .symmetries = {Symmetry::shift, Symmetry::quarter_turn, Symmetry::mirror, Symmetry::scale},
       .parameters = parameters<Params>(
           {{"cells", &Params::cells, Choices{"auto", "slab", "exact"},
             "slab: runs of lanes; exact: cut at critical points; auto: exact for order gtsp and postman, else slab"},
            {"objective", &Params::objective, Choices{"length", "time"}, "what order gtsp makes least"}},
           {"order", &Params::order, Choices{"improved", "nearest", "dfs", "gtsp", "postman"},
            "of cells; dfs: depth-first on their graph; gtsp: a generalised tour that chooses each cell's direction "
            "too; "
            "postman: a round trip that divides cells which it would cross twice"}),
       // The paper: vertical lanes, cells visited depth-first, boundaries only followed between lanes.
       .published = {{"sweep", std::string("given")},
                     {"angle", 90.0},
                     {"outline", std::string("false")},
                     {"cells", std::string("exact")},
                     {"order", std::string("dfs")}},
       .promises_with = [](const Params& p) { return p.works_walls(p.covers_walls()); }});
}

PlannerInfo trapezoid() {
  return describe<TrapezoidParams, plan_trapezoids>(
      {.name = "trapezoid",
       .family = "polygon",
       .title = "trapezoidal decomposition",
       .citation = "Latombe 1991; Choset 2001",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "covers the whole target (unless outline = false, or coverage is below 1; along traced walls but "
                    "for 0.0005 of it)",
       .promise = Promise::target,
       .symmetries = {Symmetry::shift, Symmetry::quarter_turn, Symmetry::mirror, Symmetry::scale},
       .parameters =
           parameters<TrapezoidParams>({}, {"order", &TrapezoidParams::order, Choices{"improved", "nearest", "dfs"},
                                            "of cells; dfs: depth-first on their graph"}),
       .published = {{"sweep", std::string("given")},
                     {"angle", 90.0},
                     {"outline", std::string("false")},
                     {"order", std::string("dfs")}},
       .promises_with = [](const TrapezoidParams& p) { return p.works_walls(p.covers_walls()); }});
}

}  // namespace oxturn
