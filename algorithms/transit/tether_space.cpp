// Complexity  O((n + k) log n) for n vertices of configuration space and k pieces of the cut; one path search for each
//             component that can be entered only across the cut
// Decisions   1. The strip removed along the cut is r / 100 wide (w / 200 for robots without size): far above the chord
//                error of the cut and above rounding, far below what a tool reaches across.
//             2. The cut of free space extends into the walls by r, as seen from configuration space, so it divides
//                that without loose ends. For robots without size its ends are lengthened by two widths of the strip.
//             3. A component is entered at its vertex nearest to the anchor.
//             4. Components smaller than a hundredth of the tool width squared are negligible.
#include "algorithms/transit/tether_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/overlay/cut_along.hpp"
#include "geometry/trace.hpp"

namespace oxturn {
namespace {

constexpr double kCutsPerRadius = 100;    // widths of the strip along the cut in a robot radius
constexpr double kCutsPerTool = 200;      // the same in a tool width, for robots without size
constexpr int kLeastCutBits = -22;        // the strip is at least 2^this of the map's extent: cut_along needs 2^-26
constexpr double kChordPerCut = 1.0 / 8;  // chord error of the cut, in widths of the strip
constexpr double kNegligible = 100;       // components smaller than a tool width squared over this are negligible
constexpr double kEntrySlack = 6;         // radii by which the tether may be longer than the geodesic at an entry

double cut_width_of(const Problem& problem, const std::string& planner) {
  const Robot& robot = problem.robot();
  if (!robot.tether)
    throw Unsupported(fmt::format("planner '{}' needs a robot with a tether; robot '{}' has none (tether.length)",
                                  planner, robot.name));
  const double wanted = robot.radius > 0 ? robot.radius / kCutsPerRadius : robot.tool_width / kCutsPerTool;
  return std::max(wanted, std::ldexp(bounding_box(problem.configuration_space()).size().maxCoeff(), kLeastCutBits));
}

/// The pieces of the cut locus near configuration space.
std::vector<Polyline> cut_of(const Problem& problem, double width) {
  Box box = bounding_box(problem.configuration_space());
  box.grow(width);
  std::vector<Polyline> kept;
  for (Polyline& line : problem.tether()->geodesics().cut_locus(width * kChordPerCut)) {
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

bool nearly_contains(const Polygon& polygon, const Point& p, double tolerance) {
  const EdgeIndex walls(Region{{polygon}});
  return walls.contains(p) || walls.nearest(p, tolerance).has_value();
}

}  // namespace

TetherSpace::TetherSpace(const Problem& problem, const std::string& planner)
    : problem_(problem), width_(cut_width_of(problem, planner)), cut_(cut_of(problem, width_)) {
  cut_open();
}
TetherSpace::~TetherSpace() = default;

void TetherSpace::cut_open() {
  const Region& space = problem_.configuration_space();
  Region all = cut_.empty() ? space : cut_along(space, cut_, width_);
  const auto home = std::find_if(all.polygons.begin(), all.polygons.end(), [&](const Polygon& polygon) {
    return nearly_contains(polygon, problem_.start(), problem_.tolerance());
  });
  if (home == all.polygons.end())
    throw Infeasible(
        fmt::format("the start ({}, {}) has two shortest paths to the anchor, one on either side of an obstacle; move "
                    "it a little to one side",
                    problem_.start().x(), problem_.start().y()));
  for (const Polygon& polygon : all.polygons)  // the guarantees of all users rest on this
    if (!polygon.holes.empty())
      throw std::logic_error(
          fmt::format("the cut locus of '{}' leaves a closed path round the obstacle at ({:.6g}, {:.6g})",
                      problem_.map().name, polygon.holes[0][0].x(), polygon.holes[0][0].y()));
  components_.push_back({problem_.restricted(Region{{*home}}), {problem_.start()}});
  all.polygons.erase(home);
  add_components(std::move(all.polygons));
}

void TetherSpace::add_components(std::vector<Polygon> polygons) {
  const double negligible = problem_.robot().tool_width * problem_.robot().tool_width / kNegligible;
  struct Candidate {
    double distance;  // of the entry from the anchor
    Polygon* polygon;
    Point entry;
    Polyline path;
  };
  std::vector<Candidate> candidates;
  for (Polygon& polygon : polygons) {
    Point entry{0, 0};
    std::optional<Polyline> path;
    if (area(polygon) > negligible) path = path_into(polygon, entry);
    if (path)
      candidates.push_back({field().distance(entry), &polygon, entry, std::move(*path)});
    else
      unreached_.polygons.push_back(polygon);
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  for (Candidate& c : candidates)
    components_.push_back({problem_.restricted(Region{{std::move(*c.polygon)}}, c.entry), std::move(c.path)});
}

std::optional<Polyline> TetherSpace::path_into(const Polygon& component, Point& entry) const {
  const auto nearer = [&](const Point& a, const Point& b) {
    const double da = field().distance(a), db = field().distance(b);
    return da != db ? da < db : before(a, b);
  };
  entry = *std::min_element(component.outer.begin(), component.outer.end(), nearer);
  auto path = geodesic_path(world(), problem_.start(), entry, kEntrySlack * problem_.robot().radius + width_);
  if (!path || !keeps_limit(*path)) return std::nullopt;
  return path;
}

/// Of a path that begins with the tether along the geodesic.
bool TetherSpace::keeps_limit(const Polyline& path) const {
  TautTether tether(problem_.tether()->taut_space(), problem_.anchor());
  tether.drive(field().path(path.front()));
  for (std::size_t k = 1; k < path.size(); ++k) {
    tether.drive(path[k]);
    if (tether.length() > tether_length() + problem_.tolerance()) return false;
  }
  return true;
}

const TetheredWorld& TetherSpace::world() const {
  if (!world_)
    world_ = std::make_unique<const TetheredWorld>(problem_.map().free, problem_.configuration_space(), cut_space(),
                                                   field(), tether_length(), problem_.tolerance());
  return *world_;
}

Polyline TetherSpace::path(const Component& from_component, const Point& from, const Component& to_component,
                           const Point& to) const {
  const auto inside = [&](const Component& component, const Point& a, const Point& b) {
    auto found = component.problem.transit().path(a, b);
    if (!found)
      throw std::logic_error(
          fmt::format("no path from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) within one component of the cut space", a.x(),
                      a.y(), b.x(), b.y()));
    return std::move(*found);
  };
  if (&from_component == &to_component) return inside(from_component, from, to);
  Polyline whole = inside(from_component, from, from_component.problem.start());
  const auto append = [&](const Polyline& line) { whole.insert(whole.end(), line.begin() + 1, line.end()); };
  append(Polyline(from_component.entry_path.rbegin(), from_component.entry_path.rend()));
  append(to_component.entry_path);
  append(inside(to_component, to_component.problem.start(), to));
  // Pulled taut, the path keeps its class, but the tether may exceed its limit for a moment; on `whole` it never does.
  Polyline taut = pulled_taut(world(), whole);
  return keeps_limit(taut) ? taut : whole;
}

namespace {

using Cover = std::function<Path(const TetherSpace::Component&, Context&)>;

/// Covers the components one after the other.
class ComponentTour {
 public:
  ComponentTour(const TetherSpace& space, Context& context)
      : space_(space),
        components_(space.components()),
        context_(context),
        at_(space.problem().start()),
        done_(components_.size(), false) {}

  Path run(const Cover& cover, bool return_home) {
    bool any = false;
    std::string refusal;  // why the first skipped component is infeasible
    for (std::size_t count = 0; count < components_.size() && !context_.cancelled(); ++count) {
      Next next = nearest(count == 0);
      done_[next.component] = true;
      // What `cover` publishes does not begin at the problem's start, so only finished components are published.
      Context::Sinks sinks;
      if (context_.wants_traces())
        sinks.trace = [&](const Trace& trace) {
          context_.trace(count == 0 ? trace.name : fmt::format("{} {}", trace.name, count + 1), trace.lines);
        };
      Context inner(context_.rng().bits(), context_.seconds_left(), std::move(sinks));
      try {
        const Path path = cover(components_[next.component], inner);
        append(next.path);
        append(path, next.component);
        any = true;
        context_.publish(whole_);
      } catch (const Infeasible& e) {
        if (refusal.empty()) refusal = e.what();
      }
    }
    if (!any && !refusal.empty()) throw Infeasible(refusal);
    if (return_home && !context_.cancelled())
      append(space_.path(components_[last_], at_, components_[0], space_.problem().start()));
    return std::move(whole_);
  }

 private:
  struct Next {
    std::size_t component = 0;
    Polyline path;  // to its entry
  };
  /// The component not yet done whose entry has the shortest path. The first one is always the start's.
  Next nearest(bool first) const {
    std::vector<std::size_t> open;
    for (std::size_t k = 0; k < components_.size(); ++k)
      if (!done_[k] && (!first || k == 0)) open.push_back(k);
    const auto straight = [&](std::size_t k) { return distance(at_, components_[k].problem.start()); };
    std::stable_sort(open.begin(), open.end(), [&](std::size_t a, std::size_t b) { return straight(a) < straight(b); });
    Next next;
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t k : open) {
      if (straight(k) >= least) break;
      Polyline path = space_.path(components_[last_], at_, components_[k], components_[k].problem.start());
      if (length(path) >= least) continue;
      least = length(path);
      next = {k, std::move(path)};
    }
    return next;
  }

  void append(const Polyline& transit) {
    if (transit.size() < 2) return;
    at_ = transit.back();
    whole_.legs.push_back({false, transit});
  }
  void append(const Path& path, std::size_t component) {
    last_ = component;
    whole_.legs.insert(whole_.legs.end(), path.legs.begin(), path.legs.end());
    if (!path.legs.empty()) at_ = path.legs.back().points.back();
  }

  const TetherSpace& space_;
  const std::vector<TetherSpace::Component>& components_;
  Context& context_;
  Path whole_;
  Point at_;
  std::size_t last_ = 0;  // the component where the robot is
  std::vector<bool> done_;
};

}  // namespace

Path cover_components(const TetherSpace& space, const Cover& cover, bool return_home, Context& context) {
  return ComponentTour(space, context).run(cover, return_home);
}

}  // namespace oxturn
