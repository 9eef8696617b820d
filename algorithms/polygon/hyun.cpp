// Drives horizontal lines from contact to contact, then goes to the nearest contact not yet visited.
//
// Source      Hyun (heuristic sweeping): W. K. Hyun, "A heuristic sweeping algorithm for autonomous smearing robot",
//             Honam University
// Model       horizontal lines on exact configuration space, offline, omnidirectional robot that does not rotate: disc
//             or convex polygon
// Guarantee   each tracking point is visited exactly once; every link lies in configuration space; links with the tool
//             on never cross each other. No deadlock: every remaining point can be reached. With `outline`, both
//             contacts on every line and a separation of at most the tool's width w it covers the whole target (along
//             traced walls but for 0.0005 of it, see straightened_space in outline.hpp): the
//             boundary of configuration space C covers all points within w/2 of it; from any other point of C the foot
//             on its slab's line is no farther than w/2, so it lies in C, on a lane that is not dropped.
// Complexity  n edges, k tracking points, j jumps: O(n + k log k) and j paths, by TLPPA O(N log N) each for N cells
// Decisions   1. Both contacts of every free interval are tracking points. `passes = alternate` is the source to the
//                letter: contacts of one side only on each pass.
//             2. Steps 3, 5 and 6 of the source contradict each other. rules = improved: first the other end of the
//                current interval. Else the nearest untracked point on the next line, in the direction of the last such
//                step, then on the line on the other side, if a step leads there without crossing an earlier link. Else
//                the nearest point of all, by the path planner if the straight segment is blocked. A step is a straight
//                segment (along a wall: to a contact of the same side), or vertical (x fixed, as in the source's pass)
//                and then along one of the two lines, which gets round what bulges in between without diagonals.
//                rules = published follows the steps as printed: right contacts are sought from the left wall and left
//                contacts from the right wall, but from an obstacle's contact those on the same side of the same
//                obstacle; on the current line, the next, the previous, then all.
//             3. Obstacles are the holes of configuration space, numbered: obstacles that the robot cannot pass between
//                count as one.
//             4. Lines begin at the top of configuration space, and one more runs at its bottom: without it a strip up
//                to one separation wide stays uncovered there. Lines and contacts keep 1e-6 tool widths off walls.
//                With `outline` lines begin half a separation below the top of what the outline leaves, and intervals
//                beside which it leaves nothing are dropped, as in passages no wider than the tool.
//             5. The separation follows the tool: its width where the outline is driven as well, which covers
//                everything once, else half of that. separation_by = robot is the source: half the robot's width, or
//                half the tool's if that is less. A tool as wide as the robot then covers everything twice, a wider one
//                more often.
//             6. The tool is on along lines and on links between neighbouring lines. It is off on other jumps: they
//                lead over covered ground and must cross it where an obstacle encloses the rest. `links_crossing`
//                counts the pairs of crossing links with the tool on, `transits_crossing` the other pairs.
//             7. `nearest = air` is the source: straight distance, even through a wall. `nearest = path` (ours) takes
//                the point with the shortest path.
//             8. Where the cells of TLPPA admit no path, the exact shortest path is driven and counted as
//                `tlppa_failed`.
//             9. `outline` (ours) drives the boundary of configuration space as well: without it slivers between lines
//                stay uncovered along slanted walls.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <set>
#include <stdexcept>
#include <utility>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lanes/lanes.hpp"
#include "algorithms/lanes/outline.hpp"
#include "algorithms/polygon/link_crossings.hpp"
#include "algorithms/polygon/tracking_points.hpp"
#include "algorithms/transit/connector.hpp"
#include "algorithms/transit/nearest_component.hpp"
#include "algorithms/transit/tlppa.hpp"
#include "geometry/point_grid.hpp"

namespace oxturn {
namespace {

constexpr int kMostLines = 1000000;
constexpr double kMostSquares = 1e8;  // of the separation, in configuration space
constexpr double kKeepOff = 1e-6;     // tool widths between tracking points and the boundary
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// In the order of their names in hyun().
enum class Passes { both, alternate };
enum class Rules { improved, published };
enum class NearestBy { straight_distance, path_length };
enum class TransitBy { tlppa, visibility };
enum class SeparationBy { tool, robot };

struct Params {
  double separation = 0;
  SeparationBy separation_by = SeparationBy::tool;
  double delta_x = 0;
  Passes passes = Passes::both;
  Rules rules = Rules::improved;
  NearestBy nearest = NearestBy::straight_distance;
  TransitBy transit = TransitBy::tlppa;
  double cell_size = 0;
  bool outline = true;
};

/// The links with the tool on between two neighbouring lines. None crosses another: their ends are in the same order on
/// both lines.
class StepsBetween {
 public:
  /// May a step from x = `upper` on the upper line to x = `lower` on the lower one be added?
  bool fits(double upper, double lower) const {
    const auto after = steps_.upper_bound({upper, kInfinity}), here = steps_.lower_bound({upper, -kInfinity});
    return (here == steps_.begin() || std::prev(here)->second <= lower) &&
           (after == steps_.end() || after->second >= lower);
  }
  void add(double upper, double lower) { steps_.insert({upper, lower}); }

 private:
  std::set<std::pair<double, double>> steps_;
};

/// One run of the planner.
class HyunRun {
 public:
  HyunRun(const Params& p, const Problem& problem, Context& context, double separation)
      : p_(p),
        problem_(problem),
        context_(context),
        separation_(separation),
        connector_(problem),
        lines_(lines_of(p, problem, separation)),
        positions_(positions_of(lines_)),
        untracked_(positions_),
        untracked_on_(lines_.first.size() - 1),
        steps_below_(lines_.first.size() - 1),
        path_(problem.start()) {
    if (p.nearest == NearestBy::path_length) by_path_.emplace(problem);
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      if (p.passes == Passes::alternate && !met_on_pass(point(i))) {
        untracked_.remove(i);
        continue;
      }
      untracked_on_[line_of(i)].insert({positions_[i].x(), i});
      if (by_path_) by_path_->add(positions_[i], static_cast<int>(i), i);
    }
  }

  Path run() {
    const std::size_t all = untracked_.remaining();
    if (untracked_on_.empty()) return {};  // the outline covers everything
    if (all == 0) throw Infeasible("no line has a tracking point; a smaller separation or delta_x may give some");
    std::size_t at = first_point();
    path_.drive(connector_.path(path_.at(), positions_[at]), false);
    for (std::size_t done = 1; done < all && !context_.cancelled(); ++done) {
      track(at);
      at = go_on(at);
      context_.progress(static_cast<double>(done) / static_cast<double>(all));
    }
    record_figures(all);
    if (context_.wants_traces()) trace();
    return path_.take();
  }

 private:
  /// With the outline, which covers half a tool's width beside it, lines are needed for what is left.
  static TrackingLines lines_of(const Params& p, const Problem& problem, double separation) {
    const double tool = problem.robot().tool_width, keep_off = kKeepOff * tool;
    const Region& space = problem.configuration_space();
    if (!p.outline) return tracking_lines(space, separation, keep_off, p.delta_x);
    return tracking_lines(space, lane_region(problem, tool / 2, tool / 50), separation, keep_off, p.delta_x);
  }
  static std::vector<Point> positions_of(const TrackingLines& lines) {
    std::vector<Point> all;
    for (const TrackingPoint& t : lines.points) all.push_back(t.at);
    return all;
  }
  /// The source's passes: to the right on even lines, meeting the left wall first and then right contacts; to the left
  /// on odd lines, meeting left contacts only.
  static bool met_on_pass(const TrackingPoint& t) {
    return t.line % 2 == 0 ? !is_left(t.status) || t.status == Contact::left_wall : is_left(t.status);
  }
  std::size_t first_point() const {
    for (const auto& line : untracked_on_)
      if (!line.empty()) return line.begin()->second;
    return 0;
  }
  const TrackingPoint& point(std::size_t i) const { return lines_.points[i]; }
  std::size_t line_of(std::size_t i) const { return static_cast<std::size_t>(point(i).line); }
  /// The other contact of the same free interval.
  std::size_t other_end(std::size_t i) const { return is_left(point(i).status) ? i + 1 : i - 1; }
  bool tracked(std::size_t i) const { return !untracked_on_[line_of(i)].contains({positions_[i].x(), i}); }
  void track(std::size_t i) {
    untracked_on_[line_of(i)].erase({positions_[i].x(), i});
    untracked_.remove(i);
    if (by_path_) by_path_->remove(static_cast<int>(i));
  }

  /// Drives to the next point and returns it.
  std::size_t go_on(std::size_t at) {
    return p_.rules == Rules::published ? go_on_as_published(at) : go_on_improved(at);
  }

  std::size_t go_on_as_published(std::size_t at) {
    for (const int lines_on : {0, 1, -1}) {
      const auto next = nearest_on(at, lines_on, [&](const TrackingPoint& t) { return sought_from(point(at), t); });
      if (next && connector_.straight(positions_[at], positions_[*next]))
        return link(*next, {positions_[at], positions_[*next]});
    }
    return jump(at);
  }
  /// The contacts that the source's steps 1 and 4 search for.
  static bool sought_from(const TrackingPoint& from, const TrackingPoint& to) {
    if (from.obstacle == 0) return is_left(from.status) != is_left(to.status);
    return is_left(from.status) == is_left(to.status) && from.obstacle == to.obstacle;
  }

  std::size_t go_on_improved(std::size_t at) {
    if (const std::size_t other = other_end(at); !tracked(other))
      return link(other, {positions_[at], positions_[other]});
    for (const int lines_on : {direction_, -direction_}) {
      const auto next = nearest_on(at, lines_on, [](const TrackingPoint&) { return true; });
      if (!next) continue;
      const Polyline path = step(at, *next);
      if (path.empty()) continue;
      direction_ = lines_on;
      return link(*next, path);
    }
    return jump(at);
  }

  /// The untracked point with `wanted(point)` nearest in x, on the line so many lines below.
  template <class Wanted>
  std::optional<std::size_t> nearest_on(std::size_t at, int lines_on, Wanted wanted) const {
    const int line = point(at).line + lines_on;
    if (line < 0 || line >= static_cast<int>(untracked_on_.size())) return std::nullopt;
    const auto& points = untracked_on_[static_cast<std::size_t>(line)];
    std::optional<std::size_t> best;
    const double x = positions_[at].x();
    const auto look = [&](std::size_t i) {
      if (!wanted(point(i))) return false;
      if (!best || std::abs(positions_[i].x() - x) < std::abs(positions_[*best].x() - x)) best = i;
      return true;
    };
    const auto middle = points.lower_bound({x, 0});
    for (auto i = middle; i != points.end() && !look(i->second);) ++i;
    for (auto i = middle; i != points.begin() && !look((--i)->second);) {}
    return best;
  }

  /// A free path to a point of a neighbouring line that crosses no earlier step: straight, or along one of the two
  /// lines and vertical. It counts as an earlier step from now on. Empty if there is none.
  Polyline step(std::size_t from, std::size_t to) {
    const Point &a = positions_[from], &b = positions_[to];
    struct Candidate {
      Polyline points;
      double x_from, x_to;  // where it leaves the one line and reaches the other
    };
    const Candidate straight{{a, b}, a.x(), b.x()}, vertical_first{{a, {a.x(), b.y()}, b}, a.x(), a.x()},
        along_first{{a, {b.x(), a.y()}, b}, b.x(), b.x()};
    const bool same_side = is_left(point(from).status) == is_left(point(to).status);
    const std::array<const Candidate*, 3> candidates = same_side ? std::array{&straight, &vertical_first, &along_first}
                                                                 : std::array{&vertical_first, &along_first, &straight};
    StepsBetween& steps = steps_below_[static_cast<std::size_t>(std::min(point(from).line, point(to).line))];
    const bool downwards = point(from).line < point(to).line;
    for (const Candidate* c : candidates) {
      const double upper = downwards ? c->x_from : c->x_to, lower = downwards ? c->x_to : c->x_from;
      bool free = steps.fits(upper, lower);
      for (std::size_t i = 1; free && i < c->points.size(); ++i)
        free = connector_.straight(c->points[i - 1], c->points[i]);
      if (!free) continue;
      steps.add(upper, lower);
      return c->points;
    }
    return {};
  }

  std::size_t link(std::size_t to, const Polyline& path) {
    links_.push_back(path);
    path_.drive(path, true);
    return to;
  }

  struct Target {
    std::size_t point;
    std::optional<Polyline> shortest;  // the path to it, if it was searched for by path length
  };
  Target nearest_of_all(std::size_t from) {
    if (by_path_)
      if (auto found = by_path_->from(positions_[from])) return {found->id, std::move(found->path)};
    Target target{from, std::nullopt};
    untracked_.visit(positions_[from], [&](std::size_t i, double) {
      target.point = i;
      return false;
    });
    return target;
  }

  /// To the nearest remaining point: a step with the tool on if it is near and on a neighbouring line, else transit.
  std::size_t jump(std::size_t from) {
    Target target = nearest_of_all(from);
    const std::size_t to = target.point;
    const Point &a = positions_[from], &b = positions_[to];
    if (std::abs(point(from).line - point(to).line) == 1 && distance(a, b) <= problem_.robot().tool_width)
      if (const Polyline path = step(from, to); !path.empty()) return link(to, path);
    if (connector_.straight(a, b)) return transit(to, {a, b});
    const Polyline path = planned_path(a, b, std::move(target.shortest));
    planned_paths_.push_back(path);
    return transit(to, path);
  }
  Polyline planned_path(const Point& a, const Point& b, std::optional<Polyline> shortest) {
    if (p_.transit == TransitBy::tlppa) {
      if (!tlppa_) tlppa_ = std::make_unique<Tlppa>(problem_, p_.cell_size > 0 ? p_.cell_size : separation_ / 2);
      if (auto path = tlppa_->path(a, b)) return std::move(*path);
      ++tlppa_failed_;
    }
    return shortest ? std::move(*shortest) : connector_.path(a, b);
  }
  std::size_t transit(std::size_t to, const Polyline& path) {
    path_.drive(path, false);
    transits_.push_back(path);
    return to;
  }

  void record_figures(std::size_t all) {
    const LinkCrossings crossings = count_crossings(links_, transits_);
    context_.record("tracking_points", static_cast<double>(all));
    context_.record("links_planned", static_cast<double>(planned_paths_.size()));
    context_.record("links_crossing", static_cast<double>(crossings.links));
    context_.record("transits_crossing", static_cast<double>(crossings.transits));
    if (p_.transit == TransitBy::tlppa) context_.record("tlppa_failed", static_cast<double>(tlppa_failed_));
  }
  void trace() {
    std::vector<Polyline> squares;
    const double r = separation_ / 8;
    for (const TrackingPoint& t : lines_.points)
      squares.push_back(
          {t.at + Point(-r, -r), t.at + Point(r, -r), t.at + Point(r, r), t.at + Point(-r, r), t.at + Point(-r, -r)});
    context_.trace("tracking-points", std::move(squares));
    context_.trace("planned-links", planned_paths_);
  }

  const Params& p_;
  const Problem& problem_;
  Context& context_;
  double separation_;
  Connector connector_;
  TrackingLines lines_;
  std::vector<Point> positions_;  // of the tracking points
  PointGrid untracked_;
  std::optional<NearestComponent> by_path_;                             // untracked points, if nearest by path length
  std::vector<std::set<std::pair<double, std::size_t>>> untracked_on_;  // by line, left to right: x and point
  std::vector<StepsBetween> steps_below_;                               // by line
  std::unique_ptr<Tlppa> tlppa_;
  int direction_ = 1;  // of the last step to a neighbouring line: 1 down, -1 up
  PathBuilder path_;
  std::vector<Polyline> links_, transits_, planned_paths_;
  std::size_t tlppa_failed_ = 0;
};

double separation_of(const Params& p, const Robot& robot) {
  if (p.separation > 0) return p.separation;
  const double tool = robot.tool_width, width = height(robot);
  if (p.separation_by == SeparationBy::robot) return (width > 0 ? std::min(width, tool) : tool) / 2;
  return p.outline ? tool : tool / 2;
}

Path plan(const Params& p, const Problem& problem, Context& context) {
  const double tool = problem.robot().tool_width, separation = separation_of(p, problem.robot());
  const double lines = bounding_box(problem.configuration_space()).size().y() / separation;
  if (lines > kMostLines)
    throw std::invalid_argument(
        fmt::format("planner 'hyun': separation {} m makes {:.0f} lines, expected at most {}; take a larger "
                    "separation or a wider tool",
                    separation, lines, kMostLines));
  if (const double squares = area(problem.configuration_space()) / separation / separation; squares > kMostSquares)
    throw std::invalid_argument(
        fmt::format("planner 'hyun': separation {} m makes {:.3g} squares of that side, more than {:g}; take a larger "
                    "separation or a wider tool",
                    separation, squares, kMostSquares));
  Path path = HyunRun(p, problem, context, separation).run();
  if (!p.outline || context.cancelled()) return path;
  context.publish(path);
  return with_outline(problem, path, tool, Connector(problem), context);
}

}  // namespace

PlannerInfo hyun() {
  return describe<Params, plan>(
      {.name = "hyun",
       .family = "grid",
       .title = "heuristic sweep from contact to contact",
       .citation = "Hyun, heuristic sweeping algorithm",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "covers the whole target (with outline, both contacts and at most a tool width between lines; "
                    "along traced walls but for 0.0005 of it); links with the tool on never cross",
       .promise = Promise::target,
       .symmetries = {Symmetry::shift, Symmetry::scale},
       .parameters = {{"separation", &Params::separation, Range{0, 1000},
                       "metres between lines; 0: as `separation_by` says"},
                      {"separation_by", &Params::separation_by, Choices{"tool", "robot"},
                       "tool: its width, or half of it without outline; robot: half its width, or half the tool's if "
                       "that is less, as in the source"},
                      {"delta_x", &Params::delta_x, Range{0, 1000},
                       "metres; contacts lie on a raster this fine; 0: exact"},
                      {"passes", &Params::passes, Choices{"both", "alternate"},
                       "both: contacts at both ends; alternate: those of one side on each line, as in the source"},
                      {"rules", &Params::rules, Choices{"improved", "published"},
                       "improved: back and forth, without crossings; published: the steps as printed"},
                      {"nearest", &Params::nearest, Choices{"air", "path"},
                       "nearest remaining point by straight distance (air) or by path length (path)"},
                      {"transit", &Params::transit, Choices{"tlppa", "visibility"},
                       "where the straight segment is blocked: two-level grid search, or the exact shortest path"},
                      {"cell_size", &Params::cell_size, Range{0, 1000},
                       "metres; side of the fine cells of tlppa; 0: half the separation"},
                      {"outline", &Params::outline, "also drive the boundary of configuration space"}},
       .published = {{"separation_by", std::string("robot")},
                     {"passes", std::string("alternate")},
                     {"rules", std::string("published")},
                     {"nearest", std::string("air")},
                     {"transit", std::string("tlppa")},
                     {"outline", false}},
       .promises_with = [](const Params& p) {
         return p.outline && p.separation == 0 && p.passes == Passes::both && p.rules == Rules::improved;
       }});
}

}  // namespace oxturn
