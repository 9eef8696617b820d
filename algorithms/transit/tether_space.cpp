// The cut as a strip that is removed, and the components that remain.
//
// Complexity  O((n + k) log n) for n vertices of configuration space and k pieces of the cut. Components that can be
//             entered across the cut only: for each a search near it, and the vertices of the path from the start
// Decisions   1. The strip is r / 45 wide (w / 100 for robots without size): far above rounding and the shortest
//                segments that paths should have (short_segments.hpp), far below what a tool reaches over. The cut's
//                lines have few vertices, but the strip holds all of the exact cut.
//             2. The cut of free space reaches into the walls by r as seen from configuration space, so it divides that
//                without loose ends. For robots without size its loose ends are extended by a few widths of the strip.
//             3. A component is entered at its vertex nearest to the anchor. The path there goes through the nearer
//                components that the geodesic crosses: by those only the last part is searched for. These have entries
//                nearer to the anchor, so they can be found when a path asks for them, and the result is the same.
//             4. Components smaller than a hundredth of the tool's width squared are ignored.
//             5. Up to 256 components, always the one whose entry is nearest by path comes next. That takes the square
//                of their number in paths, so more are covered depth-first over the tree of their entry paths, at each
//                fork from right to left: `leashed` paths 0.1 to 4 % longer on clutter and speckle of 40 to 90 m,
//                in 1 to 27 % less time.
#include "algorithms/transit/tether_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "algorithms/grown_path.hpp"
#include "algorithms/transit/bridge_cut.hpp"
#include "algorithms/transit/connector.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/joined_lines.hpp"
#include "geometry/overlay/cut_along.hpp"
#include "geometry/point_outside.hpp"
#include "geometry/predicates.hpp"
#include "geometry/thinned.hpp"
#include "geometry/trace.hpp"

namespace oxturn {
namespace {

constexpr double kStripsPerRadius = 45;  // decision 1
constexpr double kStripsPerTool = 100;
// Of the strip's width: errors of the cut's lines. Together less than half, with ends that move by kJoint.
constexpr double kChord = 1.0 / 16, kJoint = 1.0 / 16, kThinning = 0.3;
constexpr int kLeastStripBits = -22;         // at least 2^this of the map's extent: cut_along() needs 2^-26
constexpr double kComponentsPerTool = 100;   // decision 4
constexpr std::size_t kFewComponents = 256;  // decision 5
constexpr double kEntrySlack = 6;            // radii by which the tether may be longer than the geodesic at an entry

double width_of(const Problem& problem, const std::string& planner) {
  const Robot& robot = problem.robot();
  if (!robot.tether)
    throw Unsupported(fmt::format("planner '{}' needs a robot with a tether; robot '{}' has none (tether_length)",
                                  planner, robot.name));
  const double wanted = robot.radius > 0 ? robot.radius / kStripsPerRadius : robot.tool_width / kStripsPerTool;
  return std::max(wanted, std::ldexp(bounding_box(problem.configuration_space()).size().maxCoeff(), kLeastStripBits));
}

/// The lines of the cut that meet the bounding box of configuration space.
std::vector<Polyline> near_cut(const Problem& problem, double width) {
  Box box = bounding_box(problem.configuration_space());
  box.grow(width);
  std::vector<Polyline> pieces = problem.tether()->geodesics().cut_locus(kChord * width);
  std::erase_if(pieces, [&](const Polyline& line) {
    Box around;
    for (const Point& p : line) around.add(p);
    return line.size() < 2 || !around.overlaps(box);
  });
  std::vector<Polyline> lines = joined_lines(std::move(pieces), kJoint * width);
  for (Polyline& line : lines) line = thinned(line, kThinning * width);
  if (problem.robot().radius > 0) return lines;
  const std::vector<Point> shared = common_ends(lines, 2);
  const auto beyond = [&](const Point& end, const Point& before_it) -> Point {
    const bool loose = !std::binary_search(shared.begin(), shared.end(), end, before);
    return loose ? Point(end + (end - before_it).normalized() * 2 * width) : end;
  };
  for (Polyline& line : lines) {
    const Point first = beyond(line[0], line[1]);
    line.back() = beyond(line.back(), line[line.size() - 2]);
    line.front() = first;
  }
  return lines;
}

double metres(const std::vector<Polyline>& lines) {
  double sum = 0;
  for (const Polyline& line : lines) sum += length(line);
  return sum;
}

/// Is b beyond a, seen from `at`, or does it come after a counter-clockwise? The turn begins at `zero`, or in the east
/// if there is none.
bool turned_before(const Point& at, const Point* zero, const Point& a, const Point& b) {
  const auto second_half = [&](const Point& p) {
    const int side = zero ? orientation(at, *zero, p) : p.y() > at.y() ? 1 : p.y() < at.y() ? -1 : 0;
    const double along = zero ? (*zero - at).dot(p - at) : p.x() - at.x();
    return side < 0 || (side == 0 && along < 0);
  };
  if (second_half(a) != second_half(b)) return second_half(b);
  if (const int turn = orientation(at, a, b); turn != 0) return turn > 0;
  const double da = distance(at, a), db = distance(at, b);
  return da != db ? da < db : before(a, b);
}

/// Does entry path a come before b, depth-first over the tree of entry paths? Both begin at the start.
bool earlier_in_tree(const Polyline& a, const Polyline& b) {
  std::size_t shared = 0;
  while (shared < a.size() && shared < b.size() && a[shared] == b[shared]) ++shared;
  if (shared == a.size() || shared == b.size()) return a.size() < b.size();
  return turned_before(a[shared - 1], shared > 1 ? &a[shared - 2] : nullptr, a[shared], b[shared]);
}

/// One run of cover_components().
class ComponentCover {
 public:
  ComponentCover(const TetherSpace& tether, Context& context)
      : tether_(tether),
        components_(tether.components()),
        context_(context),
        order_(components_.size()),
        grown_(context) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    if (order_.size() > kFewComponents)
      std::stable_sort(order_.begin() + 1, order_.end(), [&](std::size_t a, std::size_t b) {
        return earlier_in_tree(components_[a].entry_path, components_[b].entry_path);
      });
  }

  Path run(const std::function<Path(const TetherSpace::Component&, Context&)>& cover, bool return_home) {
    for (std::size_t k = 0; k < order_.size() && !context_.cancelled(); ++k) {
      if (k > 0 && order_.size() <= kFewComponents) bring_nearest_forward(k);
      add(cover, k);
    }
    if (covered_ == 0 && !refusal_.empty()) throw Infeasible(refusal_);
    if (return_home && !context_.cancelled()) drive(tether_.path(components_[last_], at_, components_[0], start()));
    return std::move(path_);
  }

 private:
  const Point& start() const { return tether_.problem().start(); }
  Polyline path_to(std::size_t k) const {
    return tether_.path(components_[last_], at_, components_[k], components_[k].problem.start());
  }

  /// Of order_[k] and those after it, the component whose entry is nearest by path becomes order_[k].
  void bring_nearest_forward(std::size_t k) {
    const auto first = order_.begin() + static_cast<std::ptrdiff_t>(k);
    std::vector<std::pair<double, std::size_t>> left;  // with straight distances
    for (auto c = first; c != order_.end(); ++c) left.push_back({distance(at_, components_[*c].problem.start()), *c});
    const auto next = nearest_by_path(std::move(left), [this](std::size_t c, double) { return length(path_to(c)); });
    const auto found = std::find(first, order_.end(), *next);
    std::rotate(first, found, found + 1);  // the others stay in order
  }

  void add(const std::function<Path(const TetherSpace::Component&, Context&)>& cover, std::size_t number) {
    const std::size_t next = order_[number];
    // What covering a component publishes does not begin at the problem's start: only whole components are published.
    Context::Sinks sinks = context_.traces_only();
    if (number > 0 && sinks.trace)
      sinks.trace = [this, number](const Trace& trace) {
        context_.trace(fmt::format("{} {}", trace.name, number + 1), trace.lines);
      };
    Context inner(context_.rng().bits(), context_.seconds_left(), std::move(sinks));
    try {
      const Path path = cover(components_[next], inner);
      drive(path_to(next));
      last_ = next;
      for (const Leg& leg : path.legs) append(leg);
      if (!path.legs.empty()) at_ = path.legs.back().points.back();
      ++covered_;
      grown_.offer(path_, points_);
    } catch (const Infeasible& e) {
      if (refusal_.empty()) refusal_ = e.what();
    }
  }

  void drive(const Polyline& transit) {
    if (transit.size() < 2) return;
    at_ = transit.back();
    append({false, transit});
  }
  void append(const Leg& leg) {
    points_ += leg.points.size();
    path_.legs.push_back(leg);
  }

  const TetherSpace& tether_;
  const std::vector<TetherSpace::Component>& components_;
  Context& context_;
  std::vector<std::size_t> order_;  // of components
  Path path_;
  Point at_ = start();
  std::size_t last_ = 0, covered_ = 0;
  std::size_t points_ = 0;  // of path_
  GrownPath grown_;
  std::string refusal_;
};

}  // namespace

TetherSpace::TetherSpace(const Problem& problem, const std::string& planner, TetherCut cut)
    : problem_(problem), width_(width_of(problem, planner)), cut_(near_cut(problem, width_)) {
  if (auto bridges = cut == TetherCut::least ? bridge_cut(problem, width_) : std::nullopt;
      bridges && metres(*bridges) < metres(cut_))
    cut_ = std::move(*bridges);
  cut_open();
}
TetherSpace::~TetherSpace() = default;

void TetherSpace::cut_open() {
  const Region& space = problem_.configuration_space();
  Region all = cut_.empty() ? space : cut_along(space, cut_, width_);
  const auto home = std::find_if(all.polygons.begin(), all.polygons.end(), [&](const Polygon& component) {
    return nearly_contains(component, problem_.start(), problem_.tolerance());
  });
  if (home == all.polygons.end())
    throw Infeasible(
        fmt::format("the start ({}, {}) lies where two ways around an obstacle are equally long from the anchor; "
                    "a start a little to one side of it has one tether",
                    problem_.start().x(), problem_.start().y()));
  // Everything else relies on this.
  for (const Polygon& component : all.polygons)
    if (!component.holes.empty())
      throw std::logic_error(
          fmt::format("the cut locus of '{}' does not cut open the space around the obstacle at ({:.6g}, {:.6g})",
                      problem_.map().name, component.holes[0][0].x(), component.holes[0][0].y()));
  home_ = Component{problem_.restricted(Region{{*home}}), {problem_.start()}, 0};
  all.polygons.erase(home);
  others_ = std::move(all.polygons);
}

const std::vector<TetherSpace::Component>& TetherSpace::components() const {
  if (components_.empty()) find_components();
  return components_;
}
const Region& TetherSpace::unreached() const {
  components();
  return unreached_;
}

/// The start's component and all others, as polygons 0, 1, ...
struct TetherSpace::Locator {
  explicit Locator(const Region& all) : edges(all) {
    for (std::size_t k = 0; k < all.polygons.size(); ++k)
      polygon.resize(polygon.size() + vertex_count({{all.polygons[k]}}), k);
  }

  EdgeIndex edges;
  std::vector<std::size_t> polygon;  // by edge
};

/// The start's component is polygon 0, others_[k] is polygon k + 1.
std::optional<std::size_t> TetherSpace::polygon_at(const Point& p) const {
  if (!locator_) {
    Region all = home_->problem.configuration_space();
    all.polygons.insert(all.polygons.end(), others_.begin(), others_.end());
    locator_ = std::make_unique<const Locator>(all);
  }
  const auto nearest = locator_->edges.nearest(p);
  if (!nearest || !(nearest->distance < problem_.tolerance() || locator_->edges.contains(p))) return std::nullopt;
  return locator_->polygon[nearest->edge];
}

const TetherSpace::Component* TetherSpace::component_at(const Point& p) const {
  components();
  const auto k = polygon_at(p);
  if (!k) return nullptr;
  const std::size_t component = *k == 0 ? 0 : component_of_other_[*k - 1];
  return component != kNone ? &components_[component] : nullptr;
}

void TetherSpace::find_entries() const {
  rank_of_other_.assign(others_.size(), kNone);
  const double least_area = problem_.robot().tool_width * problem_.robot().tool_width / kComponentsPerTool;
  const double slack = problem_.tolerance();
  for (std::size_t k = 0; k < others_.size(); ++k) {
    if (area(others_[k]) <= least_area) continue;
    Entry nearest{std::numeric_limits<double>::infinity(), {0, 0}, k};
    double farther = 0;  // than the nearest one: the next vertex, at least
    for (std::size_t i = 0; i < others_[k].outer.size(); ++i) {
      const Point& p = others_[k].outer[i];
      if (i > 0) farther -= distance(others_[k].outer[i - 1], p);
      if (farther > slack) continue;
      const double d = field().distance(p);
      if (d < nearest.away || (d == nearest.away && before(p, nearest.at))) nearest = {d, p, k};
      farther = std::isfinite(d) ? d - nearest.away : 0;
    }
    if (nearest.away < std::numeric_limits<double>::infinity()) entries_.push_back(std::move(nearest));
  }
  std::ranges::stable_sort(entries_, {}, &Entry::away);
  for (std::size_t rank = 0; rank < entries_.size(); ++rank) rank_of_other_[entries_[rank].other] = rank;
}

void TetherSpace::find_components() const {
  if (rank_of_other_.empty()) find_entries();
  for (std::size_t rank = 0; rank < entries_.size(); ++rank) entered(rank);
  component_of_other_.assign(others_.size(), kNone);
  components_.push_back(*home_);
  for (Entry& entry : entries_)
    if (entry.component) {
      component_of_other_[entry.other] = entry.component->index = components_.size();
      components_.push_back(std::move(*entry.component));
    }
  for (std::size_t k = 0; k < others_.size(); ++k)
    if (component_of_other_[k] == kNone) unreached_.polygons.push_back(others_[k]);
}

/// The component with the entry of that rank, found at the first call; nullptr if the robot cannot enter it.
const TetherSpace::Component* TetherSpace::entered(std::size_t rank) const {
  Entry& entry = entries_[rank];
  if (const std::size_t found = component_of_other_.empty() ? kNone : component_of_other_[entry.other]; found != kNone)
    return &components_[found];
  if (!entry.tried) {
    entry.tried = true;
    if (auto path = path_into(rank))
      entry.component = Component{problem_.restricted(Region{{others_[entry.other]}}, entry.at), std::move(*path), 0};
  }
  return entry.component ? &*entry.component : nullptr;
}

/// By the components whose entries have ranks below that. nullopt: p is in none of them.
std::optional<Polyline> TetherSpace::path_out(const Point& p, std::size_t ranks) const {
  if (rank_of_other_.empty()) find_entries();
  const auto polygon = polygon_at(p);
  if (!polygon) return std::nullopt;
  const std::size_t rank = *polygon == 0 ? kNone : rank_of_other_[*polygon - 1];
  if (*polygon > 0 && rank >= ranks) return std::nullopt;
  const Component* at = *polygon == 0 ? &*home_ : entered(rank);
  if (!at) return std::nullopt;
  Polyline path = at->entry_path;
  if (at->problem.walls().contains(at->problem.start(), p)) {  // without a triangulation
    if (p != path.back()) path.push_back(p);
    return path;
  }
  const auto inside = at->problem.transit().path(at->problem.start(), p);
  if (!inside) return std::nullopt;
  path.insert(path.end(), inside->begin() + 1, inside->end());
  return path;
}

/// By components whose entries are nearer to the anchor. nullopt: the tether is too short.
std::optional<Polyline> TetherSpace::path_into(std::size_t rank) const {
  const auto known = [this, rank](const Point& p) { return path_out(p, rank); };
  auto path = geodesic_path(world(), problem_.start(), entries_[rank].at,
                            kEntrySlack * problem_.robot().radius + width_, known);
  if (!path || !within_tether(world(), *path)) return std::nullopt;
  return path;
}

const TetheredWorld& TetherSpace::world() const {
  if (!world_) {
    auto world = std::make_unique<TetheredWorld>(
        problem_.tether()->taut_space(), problem_.walls(), problem_.configuration_space(), problem_.transit(),
        cut_problem().transit(), field(), tether_length(), problem_.tolerance());
    world->path_out = [this](const Point& p) { return path_out(p, kNone); };
    world_ = std::move(world);
  }
  return *world_;
}

Polyline TetherSpace::path(const Component& from_component, const Point& from, const Component& to_component,
                           const Point& to) const {
  const auto inside = [&](const Component& component, const Point& a, const Point& b) {
    if (component.problem.walls().contains(a, b)) return Polyline{a, b};  // without a triangulation
    auto found = component.problem.transit().path(a, b);
    if (!found)
      throw std::logic_error(
          fmt::format("no path from ({:.6g}, {:.6g}) to ({:.6g}, {:.6g}) in one component of the cut space", a.x(),
                      a.y(), b.x(), b.y()));
    return std::move(*found);
  };
  if (from_component.index == to_component.index) return inside(from_component, from, to);
  const auto append = [](Polyline& line, const Polyline& more, std::size_t skip) {
    line.insert(line.end(), more.begin() + static_cast<std::ptrdiff_t>(skip), more.end());
  };
  Polyline whole = inside(from_component, from, from_component.problem.start()), forth = to_component.entry_path;
  append(whole, Polyline(from_component.entry_path.rbegin(), from_component.entry_path.rend()), 1);
  append(forth, inside(to_component, to_component.problem.start(), to), 1);
  // Both lead over the problem's start. What is driven there and back in between is left out: it may be most of both.
  std::size_t shared = 0;  // segments
  while (whole.size() > 1 && shared + 1 < forth.size() && whole[whole.size() - 2] == forth[shared + 1]) {
    whole.pop_back();
    ++shared;
  }
  append(whole, forth, shared + 1);
  // Pulling the path taut keeps its class. On the shorter path the tether may exceed its length for a moment, on
  // `whole` it never does.
  Polyline taut = pulled_taut(world(), whole);
  return within_tether(world(), taut) ? taut : whole;
}

Path cover_components(const TetherSpace& tether,
                      const std::function<Path(const TetherSpace::Component&, Context&)>& cover, bool return_home,
                      Context& context) {
  return ComponentCover(tether, context).run(cover, return_home);
}

}  // namespace oxturn
