// Level sets of geodesic distance, complete: exact level sets in the cut space, every wall once, nothing missed.
//
// Source      ours, after Berg 2021; it solves what Berg 2021 leaves open (3.1 corners that are seen only once, 4.2
//             walls between level sets, 5.1 speed, 5.3 order and winding)
// Model       polygons with holes, disc footprint; offline, or with lidar
// Guarantee   the tether equals the geodesic to the robot's position (except on paths between components that the cut
//             isolates, tether_space.hpp): it stays within its length limit, is never wound and never driven over.
//             Covers all that configuration space within the tether's reach allows, except components that the robot
//             cannot enter. Proof of coverage: let w be the tool width, P the cut space, Q = NeededBoundary::inner. A
//             point of Q farther than w/2 from the boundary of Q can move w/2 along its geodesic within Q, in either
//             direction. So it meets a level set, at a point that level_sets.hpp keeps, or it meets the cut where that
//             is not driven: there level sets end (needed_boundary.hpp, at most 1.11 w/2 away). Any other point of P is
//             within w/2 of the driven part of the boundary.
// Complexity  n vertices, path length m spacings: field and cut O(n log n) on real maps, level sets O(levels *
//             triangles met + m log m), order as the tour
// Decisions   1. Level sets lie at (k + 1/2) w from the anchor, k = 0, 1, ...: none at the anchor itself.
//             2. Walls are driven once; the cut only where it runs across the tether (needed_boundary.hpp). Closed
//                rings are inserted into the path; open chains take part in the tour; pockets become detours.
//             3. order: `tour` (ours) orders runs of level sets by a tour on shortest paths inside P; `dfs` is
//                depth-first on the tree of pieces, `bfs` goes level by level, outwards (the traversals of Berg 2021).
//             4. winding = left (right): level sets are driven with the tether on the left (right) side only, each by
//                itself, and rings likewise wherever the tether leaves inwards; connections are free.
//             5. min_tether_angle: where the heading would come nearer to the direction of the tether's pull, the robot
//                tacks, in each component by itself: strokes at that angle to the pull, within a tool width, if there
//                is room. What covers is driven outwards (tacking.hpp), so coverage stays complete. The robot enters
//                and leaves components behind the cut straight.
//             6. Short level sets (corridors) may be covered by lanes along the tether (lanes = 4), out and back: each
//                component is planned with and without them, and the shorter path is driven. lanes = 0, or a
//                min_tether_angle, uses level sets only.
//             7. Components of up to `laps` tool squares are covered by laps along their walls and the cut as well
//                (component_laps.hpp), and driven where that is better: along corridors laps need few turns, but
//                round many obstacles they are shorter and turn more. Not with demands on the tether, nor with the
//                source's orders. Where walls and cut lie so densely that laps were both shorter and quicker in all but
//                2 of 93 components of 100 squares and more (9 generators, two tools), only laps are planned. Level
//                sets need the whole map: with more than 128 components they are left out as well if the others hold
//                little of the area (paths 0.5 % longer than with them).
//             8. The robot keeps off obstacles as with other planners (coarser_space): by up to a hundredth of its
//                radius more round their corners.
//             9. reverse = true: both demands are met by driving backwards, everywhere and without a detour
//                (gears.hpp).
#include <algorithm>
#include <cmath>
#include <functional>

#include "algorithms/lanes/outline.hpp"
#include "algorithms/lanes/repair.hpp"
#include "algorithms/online/survey_then_plan.hpp"
#include "algorithms/tethered/component_laps.hpp"
#include "algorithms/tethered/gears.hpp"
#include "algorithms/tethered/level_set_strips.hpp"
#include "algorithms/tethered/needed_boundary.hpp"
#include "algorithms/tethered/tacking.hpp"
#include "algorithms/transit/short_segments.hpp"
#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kChordsPerWidth = 1000;  // tool widths over the chord error of level sets
// Decision 7: only laps in components with at least `kFewSquares` tool squares, and a perimeter times the tool's width
// over the area from kDense to kSliver. Narrower ones are slivers, often covered by one lane along their middle.
constexpr double kFewSquares = 3;
constexpr double kDense = 0.55;
constexpr double kSliver = 3;
constexpr std::size_t kFewComponents = 128;
constexpr double kLittle = 0.03;  // of the area

// In the order of their names in berg_complete().
enum class Order { tour, dfs, bfs };

enum class Objective { both, length, time };

struct Params {
  Order order = Order::tour;
  TetherSide winding = TetherSide::any;
  double min_tether_angle = 0;
  int lanes = 4;
  int laps = 1000000;
  Objective objective = Objective::both;
  bool return_home = true;
};

/// What is to be driven in one component.
struct Parts {
  std::vector<LevelSet> sets;
  Region rings;
  std::vector<Strip> chains;
  Region pockets;
};

/// By component.
std::vector<Parts> parts_by_component(const TetherSpace& space, const std::vector<LevelSet>& sets,
                                      const NeededBoundary& boundary) {
  std::vector<Parts> parts(space.components().size());
  const auto at = [&](const Point& p) -> Parts* {
    const TetherSpace::Component* component = space.component_at(p);
    return component ? &parts[component->index] : nullptr;
  };
  for (const LevelSet& set : sets)
    if (Parts* of = at(set.line[set.line.size() / 2])) of->sets.push_back(set);
  for (const Polygon& ring : boundary.rings.polygons)
    if (Parts* of = at(ring.outer.front())) of->rings.polygons.push_back(ring);
  for (const Polygon& pocket : boundary.pockets.polygons)
    if (Parts* of = at(pocket.outer.front())) of->pockets.polygons.push_back(pocket);
  for (const Polyline& chain : boundary.chains)
    if (Parts* of = at(chain[chain.size() / 2])) of->chains.push_back({{{chain.front(), chain.back(), chain}}});
  return parts;
}

/// The same, and what driving it takes.
struct Task : Parts {
  Task(const Problem& problem_, Parts parts, const GeodesicField& field, double spacing)
      : Parts(std::move(parts)),
        problem(problem_),
        outward(outward_neighbours(sets, field, spacing)),
        connector(problem_) {}
  const Problem& problem;  // the component's
  Outward outward;
  Connector connector;
};

void reverse(Region& rings) {
  for (Polygon& polygon : rings.polygons) {
    std::reverse(polygon.outer.begin(), polygon.outer.end());
    for (Ring& hole : polygon.holes) std::reverse(hole.begin(), hole.end());
  }
}

/// A run covered by radial lanes counts as one lane.
std::size_t lane_count(const std::vector<Strip>& strips) {
  std::size_t count = 0;
  for (const Strip& strip : strips) count += strip.lanes.size();
  return count;
}

/// Depth-first over the tree of pieces, outwards.
std::vector<std::size_t> depth_first(const Outward& outward) {
  std::vector<std::size_t> sequence;
  std::vector<bool> seen(outward.size(), false);
  for (std::size_t root = 0; root < outward.size(); ++root) {  // by level
    std::vector<std::size_t> stack{root};
    while (!stack.empty()) {
      const std::size_t k = stack.back();
      stack.pop_back();
      if (seen[k]) continue;
      seen[k] = true;
      sequence.push_back(k);
      stack.insert(stack.end(), outward[k].rbegin(), outward[k].rend());
    }
  }
  return sequence;
}

Path with_task_rings(const Task& task, const Path& path, Context& context) {
  return with_rings(task.problem, task.rings, path, task.problem.robot().tool_width, task.connector, context);
}

Path drive(Order by, const Task& task, std::vector<Strip> strips, Context& context) {
  const StripOrder order = by == Order::bfs   ? StripOrder::given
                           : by == Order::dfs ? StripOrder::depth_first
                                              : StripOrder::improved;
  strips.insert(strips.end(), task.chains.begin(), task.chains.end());
  return with_task_rings(task, drive_strips(task.problem, strips, order, task.connector, context), context);
}

/// Radial lanes save the steps between short level sets, but an odd number of them ends at the far end of the run. So
/// both are tried.
Path cover_by_tour(const Params& p, const Task& task, Context& context) {
  if (p.order == Order::bfs) return drive(p.order, task, strips_of_sets(task.sets, task.outward), context);
  const std::vector<Strip> runs = strips_of_runs(task.sets, task.outward);
  Path best = drive(p.order, task, runs, context);
  if (p.lanes == 0 || p.min_tether_angle > 0 || context.cancelled()) return best;
  const std::vector<Strip> radial =
      strips_with_radial_lanes(task.sets, task.outward, task.problem.walls(),
                               {static_cast<std::size_t>(p.lanes), task.problem.robot().tool_width});
  if (lane_count(radial) == lane_count(runs)) return best;  // no run is suited
  Path other = drive(p.order, task, radial, context);
  return !context.cancelled() && other.length() < best.length() ? other : best;
}

/// Each level set in the one direction, depth-first or level by level.
Path drive_one_way(const Params& p, const Task& task, Context& context) {
  std::vector<std::size_t> sequence;
  if (p.order == Order::bfs)
    for (std::size_t k = 0; k < task.sets.size(); ++k) sequence.push_back(k);
  else
    sequence = depth_first(task.outward);
  PathBuilder path(task.problem.start());
  for (const std::size_t k : sequence) {
    if (context.cancelled()) break;
    Polyline line = task.sets[k].line;
    if (p.winding == TetherSide::right) std::reverse(line.begin(), line.end());
    path.drive(task.connector.path(path.at(), line.front()), false);
    path.drive(line, true);
  }
  return path.take();
}

/// Without stops, turning on the spot.
double seconds_to_drive(const Path& path, const Robot& robot) {
  double turned = 0;
  Point before(0, 0), heading(0, 0);
  bool first = true;
  for (const Leg& leg : path.legs)
    for (const Point& p : leg.points) {
      const Point d = p - before;
      if (!first && d.norm() > 0) {
        turned += std::abs(math::atan2(cross(heading, d), heading.dot(d)));
        heading = d;
      }
      before = p;
      first = false;
    }
  return path.length() / robot.speed + turned / robot.turn_rate;
}

bool better(Objective objective, const Path& a, const Path& b, const Robot& robot) {
  const bool shorter = a.length() < b.length();
  if (objective == Objective::length || (objective == Objective::both && !shorter)) return shorter;
  return seconds_to_drive(a, robot) < seconds_to_drive(b, robot);
}

/// With the path back to where it starts: a tethered robot comes out of a component as it went in.
Path and_back(Path path, const Problem& component) {
  if (path.legs.empty()) return path;
  const Polyline back = Connector(component).path(path.legs.back().points.back(), component.start());
  if (back.size() > 1) path.legs.push_back({false, back});
  return path;
}

/// In tool squares.
double size_of(const Problem& component) {
  const double w = component.robot().tool_width;
  return area(component.configuration_space()) / (w * w);
}

bool may_have_laps(const Params& p, const Problem& component) {
  const bool free = p.order == Order::tour && p.winding == TetherSide::any && p.min_tether_angle <= 0;
  return free && size_of(component) <= p.laps;
}

/// By component: is it covered by laps without a look at level sets (decision 7)?
std::vector<bool> laps_only(const Params& p, const TetherSpace& space) {
  std::vector<bool> only, may;
  double all = 0, others = 0;
  for (const TetherSpace::Component& component : space.components()) {
    const double squares = size_of(component.problem);
    const double density =
        perimeter(component.problem.configuration_space()) / (squares * component.problem.robot().tool_width);
    may.push_back(may_have_laps(p, component.problem));
    only.push_back(may.back() && squares >= kFewSquares && density >= kDense && density < kSliver);
    all += squares;
    if (!only.back()) others += squares;
  }
  return only.size() > kFewComponents && others < kLittle * all ? may : only;
}

/// The better one of `path` and laps.
Path or_laps(const Params& p, const CutPasses& cut, const Problem& component, Path path, Context& context) {
  if (context.cancelled() || !may_have_laps(p, component)) return path;
  Path laps = laps_in_component(cut, component, context);
  if (context.cancelled()) return path;
  const bool laps_are_better =
      better(p.objective, and_back(laps, component), and_back(path, component), component.robot());
  return laps_are_better ? laps : path;
}

void trace(const TetherSpace& space, const NeededBoundary& boundary, const std::vector<LevelSet>& sets,
           Context& context) {
  const Outward outward = outward_neighbours(sets, space.field(), space.problem().robot().tool_width);
  context.trace("rings", boundary.rings);
  context.trace("chains", boundary.chains);
  std::vector<Polyline> lines, tree;
  const auto middle = [&](std::size_t k) { return sets[k].line[sets[k].line.size() / 2]; };
  for (std::size_t k = 0; k < sets.size(); ++k) {
    lines.push_back(sets[k].line);
    for (const std::size_t b : outward[k]) tree.push_back({middle(k), middle(b)});
  }
  context.trace("level sets", std::move(lines));
  context.trace("tree of pieces", std::move(tree));
}

/// What level sets take: nothing, if all components are covered by laps.
std::vector<Parts> parts_for_level_sets(const Params& p, const TetherSpace& space, Context& context) {
  const double w = space.problem().robot().tool_width;
  const bool open = p.order == Order::tour && p.winding == TetherSide::any;
  const NeededBoundary boundary = needed_boundary(space, open ? CutEdges::across_tether : CutEdges::all);
  const std::vector<LevelSet> sets = level_sets(space, boundary.space, boundary.inner, w, w / kChordsPerWidth);
  if (context.wants_traces()) trace(space, boundary, sets, context);
  return parts_by_component(space, sets, boundary);
}

/// By level sets and, where that is better, by laps.
Path cover_by_level_sets(const Params& p, const Problem& component, const GeodesicField& field, Parts parts,
                         const CutPasses& cut, Context& context) {
  Task task(component, std::move(parts), field, component.robot().tool_width);
  if (p.winding == TetherSide::right) reverse(task.rings);
  Path path = p.winding == TetherSide::any ? cover_by_tour(p, task, context)
                                           : with_task_rings(task, drive_one_way(p, task, context), context);
  path = without_short_segments(std::move(path), component);
  path = repaired(component, path, std::move(task.pockets), task.connector, context);
  return or_laps(p, cut, component, std::move(path), context);
}

Path plan(const Params& p, const Problem& whole, Context& context) {
  const Problem problem = with_coarser_space(whole);
  const TetherSpace space(problem, "berg-complete");
  if (context.wants_traces()) context.trace("cut", space.cut());
  const std::vector<bool> only_laps = laps_only(p, space);
  std::vector<Parts> parts;
  if (!std::ranges::all_of(only_laps, std::identity{})) parts = parts_for_level_sets(p, space, context);
  const Tacking tacking{.angle = p.min_tether_angle, .width = problem.robot().tool_width};
  const CutPasses cut(problem, space.cut());
  const auto cover = [&](const TetherSpace::Component& component, Context& inner) {
    if (only_laps[component.index]) return laps_in_component(cut, component.problem, inner);
    Path path = cover_by_level_sets(p, component.problem, space.field(), std::move(parts[component.index]), cut, inner);
    const bool first = component.index == 0;  // with the transit that follows, below
    return first || tacking.angle <= 0 ? path : tacked(space.field(), component.problem, path, tacking);
  };
  Path path = cover_components(space, cover, p.return_home, context);
  if (tacking.angle > 0) path = tacked(space.field(), space.cut_problem(), path, tacking);
  context.publish(path);
  return path;
}

}  // namespace

PlannerInfo berg_complete() {
  return with_reverse(with_sensing(describe<Params, plan>(
      {.name = "berg-complete",
       .family = "tethered",
       .title = "level sets of tether distance, complete",
       .citation = "oxturn, after Berg 2021",
       .capabilities = {Capability::tether, Capability::holes},
       .guarantee = "covers all that the tether reaches, with all settings; never over its own tether, which is always "
                    "the geodesic; min_tether_angle only where there is room to tack, with reverse everywhere",
       .promise = Promise::target,
       .symmetries = {Symmetry::shift, Symmetry::scale},
       .parameters = {
           {"order", &Params::order, Choices{"tour", "dfs", "bfs"}, "of the pieces of level sets"},
           {"winding", &Params::winding, Choices{"any", "left", "right"},
            "the side of the robot on which the tether is while it drives level sets"},
           {"min_tether_angle", &Params::min_tether_angle, Range{0, kPi / 2 - 0.01},
            "radians that the heading keeps from the tether's pull, by tacking where there is room; 0: none"},
           {"lanes", &Params::lanes, Range{0, 20},
            "level sets up to this many tool widths long may be covered by lanes along the tether; 0: never"},
           {"laps", &Params::laps, Range{0, 1000000000},
            "components of up to so many tool squares may be covered by laps along walls and cut; 0: never"},
           {"objective", &Params::objective, Choices{"both", "length", "time"},
            "laps are driven where they are shorter, quicker, or both"},
           {"return_home", &Params::return_home, "drive back to the start at the end"}}})));
}

}  // namespace oxturn
