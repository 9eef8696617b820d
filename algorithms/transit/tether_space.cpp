// The cut as a slit, and the parts that it leaves.
//
// Complexity  O((n + k) log n) for n corners of configuration space and k pieces of the cut; a search for each part
//             that can only be entered across the cut
// Decisions   1. The slit is r / 100 wide (w / 200 for robots without size): far above the chord error of the cut and
//                above rounding, far below what a tool reaches over.
//             2. The cut of free space reaches into the walls by r, as seen from configuration space, so it parts it
//                without loose ends; for robots without size its ends are lengthened by a few widths of the slit.
//             3. A part is entered at the corner of it that is nearest to the anchor.
//             4. Parts smaller than a hundredth of the tool's width squared are crumbs.
#include "algorithms/transit/tether_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/overlay/cut_along.hpp"
#include "geometry/trace.hpp"

namespace oxturn {
namespace {

double width_of(const Problem& problem, const std::string& planner) {
  const Robot& robot = problem.robot();
  if (!robot.tether)
    throw Unsupported(fmt::format("planner '{}' needs a robot with a tether; robot '{}' has none (tether.length)",
                                  planner, robot.name));
  const double wanted = robot.radius > 0 ? robot.radius / 100 : robot.tool_width / 200;
  return std::max(wanted, std::ldexp(bounding_box(problem.configuration_space()).size().maxCoeff(), -22));
}

std::vector<Polyline> near_cut(const Problem& problem, double width) {
  Box box = bounding_box(problem.configuration_space());
  box.grow(width);
  std::vector<Polyline> kept;
  for (Polyline& line : problem.tether()->geodesics().cut_locus(width / 8)) {
    Box around;
    for (const Point& p : line) around.add(p);
    if (line.size() < 2 || !around.overlaps(box)) continue;
    if (problem.robot().radius <= 0) {
      const Point first = line[0] - line[1], last = line[line.size() - 1] - line[line.size() - 2];
      if (first.norm() > 0) line.insert(line.begin(), line.front() + first.normalized() * 2 * width);
      if (last.norm() > 0) line.push_back(line.back() + last.normalized() * 2 * width);
    }
    kept.push_back(std::move(line));
  }
  return kept;
}

bool holds(const Polygon& part, const Point& p, double tolerance) {
  const EdgeIndex walls(Region{{part}});
  return walls.contains(p) || walls.nearest(p, tolerance).has_value();
}

}  // namespace

TetherSpace::TetherSpace(const Problem& problem, const std::string& planner)
    : problem_(problem), width_(width_of(problem, planner)), cut_(near_cut(problem, width_)) {
  cut_open();
}
TetherSpace::~TetherSpace() = default;

void TetherSpace::cut_open() {
  const Region& space = problem_.configuration_space();
  Region all = cut_.empty() ? space : cut_along(space, cut_, width_);
  const auto home = std::find_if(all.polygons.begin(), all.polygons.end(), [&](const Polygon& part) {
    return holds(part, problem_.start(), problem_.tolerance());
  });
  if (home == all.polygons.end())
    throw Infeasible(
        fmt::format("the start ({}, {}) lies where two ways round an obstacle are equally long from the anchor; "
                    "a start a little to one side of it has one tether",
                    problem_.start().x(), problem_.start().y()));
  // What everything else rests on.
  for (const Polygon& part : all.polygons)
    if (!part.holes.empty())
      throw std::logic_error(
          fmt::format("the cut locus of '{}' does not open the way round the obstacle at ({:.6g}, {:.6g})",
                      problem_.map().name, part.holes[0][0].x(), part.holes[0][0].y()));
  parts_.push_back({problem_.restricted(Region{{*home}}), {problem_.start()}});
  all.polygons.erase(home);

  const double crumb = problem_.robot().tool_width * problem_.robot().tool_width / 100;
  struct Found {
    double away;
    Polygon* polygon;
    Point entry;
    Polyline way;
  };
  std::vector<Found> found;
  for (Polygon& polygon : all.polygons) {
    Point entry{0, 0};
    std::optional<Polyline> way;
    if (area(polygon) > crumb) way = path_into(polygon, entry);
    if (way)
      found.push_back({field().distance(entry), &polygon, entry, std::move(*way)});
    else
      slivers_.polygons.push_back(polygon);
  }
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.away < b.away; });
  for (Found& f : found)
    parts_.push_back({problem_.restricted(Region{{std::move(*f.polygon)}}, f.entry), std::move(f.way)});
}

std::optional<Polyline> TetherSpace::path_into(const Polygon& part, Point& entry) const {
  const auto nearer = [&](const Point& a, const Point& b) {
    const double da = field().distance(a), db = field().distance(b);
    return da != db ? da < db : before(a, b);
  };
  entry = *std::min_element(part.outer.begin(), part.outer.end(), nearer);
  auto way = geodesic_path(world(), problem_.start(), entry, 6 * problem_.robot().radius + width_);
  if (!way) return std::nullopt;
  TautTether string(problem_.tether()->taut_space(), problem_.anchor());
  string.drive(field().path(problem_.start()));
  for (std::size_t k = 1; k < way->size(); ++k) {
    string.drive((*way)[k]);
    if (string.length() > tether_length() + problem_.tolerance()) return std::nullopt;
  }
  return way;
}

const TetheredWorld& TetherSpace::world() const {
  if (!world_)
    world_ = std::make_unique<const TetheredWorld>(problem_.map().free, problem_.configuration_space(), cut_space(),
                                                   field(), tether_length(), problem_.tolerance());
  return *world_;
}

Polyline TetherSpace::path(const Component& from_part, const Point& from, const Component& to_part, const Point& to) const {
  const auto inside = [&](const Component& part, const Point& a, const Point& b) {
    auto found = part.problem.transit().path(a, b);
    if (!found)
      throw std::logic_error(fmt::format(
          "no way from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) in one part of the cut space", a.x(), a.y(), b.x(), b.y()));
    return std::move(*found);
  };
  if (&from_part == &to_part) return inside(from_part, from, to);
  Polyline whole = inside(from_part, from, from_part.problem.start());
  const auto append = [&](const Polyline& line) { whole.insert(whole.end(), line.begin() + 1, line.end()); };
  append(Polyline(from_part.entry_path.rbegin(), from_part.entry_path.rend()));
  append(to_part.entry_path);
  append(inside(to_part, to_part.problem.start(), to));
  Polyline taut = pulled_taut(world(), whole);
  // The pulled way keeps the class; on it the string may be longer than the leash for a moment, on the other one never.
  TautTether string(problem_.tether()->taut_space(), problem_.anchor());
  string.drive(field().path(from));
  for (std::size_t k = 1; k < taut.size(); ++k) {
    string.drive(taut[k]);
    if (string.length() > tether_length() + problem_.tolerance()) return whole;
  }
  return taut;
}

Path cover_components(const TetherSpace& leash, const std::function<Path(const TetherSpace::Component&, Context&)>& sweep, bool return_home,
                 Context& context) {
  const std::vector<TetherSpace::Component>& parts = leash.components();
  Path whole;
  Point at = leash.problem().start();
  const auto drive = [&](const Polyline& way) {
    if (way.size() < 2) return;
    at = way.back();
    whole.legs.push_back({false, way});
  };
  std::vector<bool> done(parts.size(), false);
  std::size_t last = 0, swept = 0;
  std::string refusal;
  for (std::size_t count = 0; count < parts.size() && !context.cancelled(); ++count) {
    Polyline way;
    std::size_t next = 0;
    double least = std::numeric_limits<double>::infinity();
    std::vector<std::size_t> left;
    for (std::size_t k = 0; k < parts.size(); ++k)
      if (!done[k] && (count > 0 || k == 0)) left.push_back(k);
    const auto straight = [&](std::size_t k) { return distance(at, parts[k].problem.start()); };
    std::stable_sort(left.begin(), left.end(), [&](std::size_t a, std::size_t b) { return straight(a) < straight(b); });
    for (const std::size_t k : left) {
      if (straight(k) >= least) break;
      Polyline candidate = leash.path(parts[last], at, parts[k], parts[k].problem.start());
      if (length(candidate) >= least) continue;
      least = length(candidate);
      next = k;
      way = std::move(candidate);
    }
    done[next] = true;
    // What a part's sweep publishes does not begin at the problem's start: only whole parts are published.
    Context::Sinks sinks;
    if (context.wants_traces())
      sinks.trace = [&](const Trace& trace) {
        context.trace(count == 0 ? trace.name : fmt::format("{} {}", trace.name, count + 1), trace.lines);
      };
    Context inner(context.rng().bits(), context.seconds_left(), std::move(sinks));
    try {
      const Path path = sweep(parts[next], inner);
      drive(way);
      last = next;
      for (const Leg& leg : path.legs) whole.legs.push_back(leg);
      if (!path.legs.empty()) at = path.legs.back().points.back();
      ++swept;
      context.publish(whole);
    } catch (const Infeasible& e) {
      if (refusal.empty()) refusal = e.what();
    }
  }
  if (swept == 0 && !refusal.empty()) throw Infeasible(refusal);
  if (return_home && !context.cancelled()) drive(leash.path(parts[last], at, parts[0], leash.problem().start()));
  return whole;
}

}  // namespace oxturn
