#include "algorithms/polygon/cell_directions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "algorithms/lanes/lane_direction.hpp"
#include "algorithms/tour/generalised_tour.hpp"
#include "geometry/overlay/boolean.hpp"

namespace oxturn {
namespace {

using Cells = std::vector<BoustrophedonCell>;

constexpr double kDistinct = 1;             // degrees: of nearer directions of edges the longest edge's is taken
constexpr std::size_t kMostDirections = 4;  // of a cell, besides that of the cuts
constexpr double kLevel = 1e-9;             // of a cell's extent: vertices this near to its side belong to the side
constexpr double kTurnCost = 2;             // spacings, for each lane
constexpr double kBreakCost = 4;            // spacings, for each cell
constexpr double kClearlyLess = 1 - 1e-9;

/// The vertices of a ring on one side of its box: they must follow one another.
struct Side {
  std::size_t first, last;
};
template <class On>
std::optional<Side> side_of(const Ring& ring, On on) {
  const std::size_t n = ring.size();
  std::optional<Side> side;
  for (std::size_t i = 0; i < n; ++i) {
    if (!on(ring[i]) || on(ring[(i + n - 1) % n])) continue;
    if (side) return std::nullopt;
    side = Side{i, i};
    while (on(ring[(side->last + 1) % n])) side->last = (side->last + 1) % n;
  }
  return side;
}

Polyline run_of(const Ring& ring, std::size_t from, std::size_t to) {
  Polyline run{ring[from]};
  while (from != to) run.push_back(ring[from = (from + 1) % ring.size()]);
  return run;
}

/// A counter-clockwise ring that every vertical line crosses twice at most, as chains; nullopt for other rings.
std::optional<BoustrophedonCell> chains_of(const Ring& ring) {
  const Box box = bounding_box(ring);
  const double level = kLevel * box.size().norm();
  if (box.size().x() <= 4 * level) return std::nullopt;
  const auto left = side_of(ring, [&](const Point& p) { return p.x() <= box.low.x() + level; });
  const auto right = side_of(ring, [&](const Point& p) { return p.x() >= box.high.x() - level; });
  if (!left || !right) return std::nullopt;
  BoustrophedonCell cell{run_of(ring, left->last, right->first), run_of(ring, right->last, left->first), {}};
  std::ranges::reverse(cell.upper);
  for (const Polyline* chain : {&cell.lower, &cell.upper})
    for (std::size_t k = 1; k < chain->size(); ++k)
      if ((*chain)[k].x() < (*chain)[k - 1].x() - level) return std::nullopt;
  return cell;
}

/// Directions of the edges of a ring or region in degrees, the longest edge's first.
template <class Shape>
std::vector<double> directions_by_length(const Shape& shape) {
  std::vector<std::pair<double, double>> edges;  // length, degrees
  for_each_edge(shape, [&](const Point& a, const Point& b) {
    if (const double l = distance(a, b); l > 0) edges.push_back({l, direction_of(b - a)});
  });
  std::stable_sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<double> directions;
  for (const auto& [l, degrees] : edges) directions.push_back(degrees);
  return directions;
}

/// The directions of a region's edges, so few that each needs a frame only once.
class EdgeDirections {
 public:
  explicit EdgeDirections(const Region& region) {
    for (const double degrees : directions_by_length(region))
      if (!nearest(degrees)) all_.push_back(degrees);
  }
  /// The one within a degree.
  std::optional<double> nearest(double degrees) const {
    const auto near = [&](double d) { return std::abs(std::remainder(d - degrees, 180.0)) < kDistinct; };
    const auto found = std::find_if(all_.begin(), all_.end(), near);
    return found != all_.end() ? std::optional(*found) : std::nullopt;
  }

 private:
  std::vector<double> all_;
};

/// Directions in which a cell can be driven: first along the cuts, then along its longest edges.
std::vector<DirectedCell> candidates_of(const BoustrophedonCell& cell, double cut, const EdgeDirections& directions) {
  const LaneFrame frame(cut);
  std::vector<DirectedCell> candidates{{cut, {cell.lower, cell.upper, {}}}};
  for (const double degrees : directions_by_length(outline(cell, frame))) {
    if (candidates.size() > kMostDirections) break;
    const std::optional<double> d = directions.nearest(degrees);
    if (!d || std::ranges::any_of(candidates, [&](const DirectedCell& w) { return w.degrees == *d; })) continue;
    if (auto other = turned(cell, frame, LaneFrame(*d))) candidates.push_back({*d, std::move(*other)});
  }
  return candidates;
}

struct Cut {
  double degrees = 0;
  Cells cells;
};

/// Cells for lanes in one direction, in their frame.
Cut cut_along(const Region& region, double degrees) {
  // United: rings that touch may cross by rounding once rotated, which the exact plane sweep rejects.
  return {degrees, boustrophedon_cells(unite({LaneFrame(degrees).to_frame(region)}))};
}

/// What it costs to drive a cell, about: its lanes, and two spacings for each, as in lane_direction.hpp.
double lanes_cost(const BoustrophedonCell& cell, double spacing) {
  const double width = right_of(cell) - left_of(cell);
  const double lanes = static_cast<double>(slabs_over(0, width, spacing).count);
  return lanes * (std::abs(signed_area(outline(cell, LaneFrame(90)))) / width + kTurnCost * spacing);
}

/// The decomposition whose cells take the least to drive. The source compares sums of widths; that cuts many cells
/// narrower than a lane, each of which takes one.
Cut best_cut(const Region& region, const EdgeDirections& directions, double spacing, const Context& context) {
  Cut best;
  double least = std::numeric_limits<double>::infinity();
  for (const double degrees : lane_directions(region)) {
    if (context.cancelled()) break;
    Cut cut = cut_along(region, degrees);
    double sum = 0;
    for (const BoustrophedonCell& cell : cut.cells) {
      double cheapest = std::numeric_limits<double>::infinity();
      for (const DirectedCell& candidate : candidates_of(cell, degrees, directions))
        cheapest = std::min(cheapest, lanes_cost(candidate.cell, spacing));
      sum += cheapest + kBreakCost * spacing;
    }
    if (sum >= least * kClearlyLess) continue;
    least = sum;
    best = std::move(cut);
  }
  return best;
}

/// What driving to the next lane costs beside the drive there, in metres.
double turn_cost(const Robot& robot, TourMeasure objective) {
  if (objective == TourMeasure::length) return 0;
  return robot.speed * turn_seconds(robot);
}

/// Fields by direction, made when they are first needed.
class LaneFields {
 public:
  LaneFields(const Problem& problem, double spacing) : problem_(problem), spacing_(spacing) {}
  const LaneField& along(double degrees) {
    return fields_.try_emplace(degrees, problem_, degrees, spacing_).first->second;
  }

 private:
  const Problem& problem_;
  double spacing_;
  std::map<double, LaneField> fields_;
};

/// Appends the four patterns of a cell in one direction.
void add_patterns(TourElement& element, const Strip& strip, double turn) {
  double lanes = 0;
  for (const LaneEnds& l : strip.lanes) lanes += distance(l.low, l.high) + turn;
  const std::size_t first = element.size();
  for (Pattern p : strip.patterns()) {
    p.cost += lanes;
    p.reverse += first;
    element.push_back(p);
  }
}

/// The directions of one cell that have a lane, with the patterns that may be of use.
struct Choice {
  std::vector<DirectedCell> candidates;
  std::vector<std::size_t> candidate_of;  // by pattern
  TourElement patterns;
};

Choice choice_of(std::vector<DirectedCell> candidates, LaneFields& fields, LaneFit fit, double turn,
                 const Connector& connector, Context& context) {
  TourElement all;
  std::vector<std::size_t> candidate_of;
  for (std::size_t w = 0; w < candidates.size(); ++w) {
    const std::vector<Strip> strip =
        cell_strips(fields.along(candidates[w].degrees), {candidates[w].cell}, fit, context);
    if (strip[0].lanes.empty()) continue;
    add_patterns(all, strip[0], turn);
    candidate_of.resize(all.size(), w);
  }
  Choice choice{std::move(candidates), {}, {}};
  const std::vector<std::size_t> kept =
      undominated(all, [&](const Point& a, const Point& b) { return connector.length(a, b); });
  for (const std::size_t k : kept) {
    const auto reverse = std::ranges::lower_bound(kept, all[k].reverse) - kept.begin();
    choice.patterns.push_back({all[k].entry, all[k].exit, all[k].cost, static_cast<std::size_t>(reverse)});
    choice.candidate_of.push_back(candidate_of[k]);
  }
  return choice;
}

}  // namespace

std::optional<BoustrophedonCell> turned(const BoustrophedonCell& cell, const LaneFrame& from, const LaneFrame& to) {
  Ring ring = outline(cell, from);
  for (Point& p : ring) p = to.to_frame(p);
  return chains_of(ring);
}

std::vector<DirectedCell> directed_cells(const Problem& problem, const Region& region, const CellDirections& options,
                                         Context& context) {
  const EdgeDirections directions(region);
  const Cut cut =
      options.cut ? cut_along(region, *options.cut) : best_cut(region, directions, options.spacing, context);
  const double turn = turn_cost(problem.robot(), options.objective);
  const Connector connector(problem);
  LaneFields fields(problem, options.spacing);
  std::vector<Choice> choices;
  std::vector<TourElement> elements;
  for (const BoustrophedonCell& cell : cut.cells) {
    if (context.cancelled()) break;
    Choice choice =
        choice_of(candidates_of(cell, cut.degrees, directions), fields, options.fit, turn, connector, context);
    if (choice.patterns.empty()) continue;
    elements.push_back(choice.patterns);
    choices.push_back(std::move(choice));
  }
  const TourCosts costs(problem.start(), elements, connector);
  std::vector<DirectedCell> cells;
  for (const TourStop& stop : generalised_tour(costs, context)) {
    const Choice& choice = choices[stop.element];
    cells.push_back(choice.candidates[choice.candidate_of[stop.pattern]]);
  }
  context.record("cells", static_cast<double>(cells.size()));
  return cells;
}

std::vector<Strip> strips_of(const Problem& problem, const std::vector<DirectedCell>& cells,
                             const CellDirections& options, Context& context) {
  std::map<double, Cells> by_direction;
  for (const DirectedCell& c : cells) by_direction[c.degrees].push_back(c.cell);
  std::vector<Strip> strips;
  for (const auto& [degrees, all] : by_direction)
    for (Strip& strip : cell_strips(LaneField(problem, degrees, options.spacing), all, options.fit, context))
      if (!strip.lanes.empty()) strips.push_back(std::move(strip));
  return strips;
}

}  // namespace oxturn
