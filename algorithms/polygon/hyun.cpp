// Sweeps along horizontal lines from contact to contact, then goes on at the nearest place that is left.
//
// Source      W. K. Hyun, "A heuristic sweeping algorithm for autonomous smearing robot", Honam University
// Model       sweep lines on exact configuration space, offline, omnidirectional robot that does not turn: disc or convex
//             polygon
// Guarantee   each tracking point is visited exactly once, every link is driven inside configuration space, and the links
//             that the tool is on for never cross; there is no deadlock, as any point that is left can be gone to
// Complexity  n edges, k tracking points, j jumps: O(n + k log k) and j ways: TLPPA O(N log N) each for N of its cells
// Decisions   1. Both contacts of every free interval are tracking points. `passes = alternate` is the source to the
//                letter: one side only on each pass.
//             2. The source's steps 3, 5 and 6 contradict each other. Here: the other end of the own interval; else the
//                nearest untracked point on the line onwards, in the direction of the last such step, then on the line on
//                the other side, if a step leads there that crosses no earlier link; else the nearest of all, by the
//                planner if the straight way is blocked. A step is straight (along a wall: to a contact of the same
//                side), or straight across with x fixed, as in the source's pass, and along one of the two lines, which
//                gets it round what bulges between two lines without diagonals. `rules = literal` is the steps as printed: right contacts
//                are sought from the left wall and the reverse, but from an obstacle's contact those on the same side of
//                the same obstacle; own line, line onwards, line back, all.
//             3. Obstacles are the holes of configuration space, numbered: what the robot cannot pass between is one.
//             4. Lines begin at the top of configuration space and one more runs at its bottom: without it up to a
//                separation stays unswept there. They and the contacts keep off the border by 1e-6 of the tool's width.
//             5. The separation is half of the robot's width, as printed, or half of the tool's if that is less. A tool as
//                wide as the robot then sweeps everything twice.
//             6. The tool is on along lines and on links between neighbouring lines; on other jumps it is off: they lead
//                over what is swept already, and must cross it where an obstacle shuts the rest in. `links_crossing`
//                counts the pairs of links with the tool on that cross, `transits_crossing` the others.
//             7. `nearest = air` is the source: as the crow flies, also through a wall. `nearest = way` (ours) takes the
//                point with the shortest way.
//             8. Where TLPPA's cells show no way, the shortest path is taken, and counted (`tlppa_failed`).
//             9. `outline` (ours) drives the border of configuration space as well: between lines, slanted walls keep
//                slivers.
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
#include "algorithms/polygon/link_crossings.hpp"
#include "algorithms/transit/nearest_component.hpp"
#include "algorithms/polygon/tracking_points.hpp"
#include "algorithms/lanes/outline.hpp"
#include "algorithms/tour/point_grid.hpp"
#include "algorithms/transit/connector.hpp"
#include "algorithms/transit/tlppa.hpp"

namespace oxturn {
namespace {

constexpr int kMostLines = 1000000;

struct Params {
  double separation = 0;
  double delta_x = 0;
  std::string passes = "both";
  std::string rules = "resolved";
  std::string nearest = "air";
  std::string transit = "tlppa";
  double cell_size = 0;
  bool outline = false;
};

/// The links with the tool on between two neighbouring lines, none crossing another: their ends are in the same order on
/// both lines.
class Steps {
 public:
  bool fits(double upper, double lower) const {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    const auto after = steps_.upper_bound({upper, kFar}), here = steps_.lower_bound({upper, -kFar});
    return (here == steps_.begin() || std::prev(here)->second <= lower) &&
           (after == steps_.end() || after->second >= lower);
  }
  void add(double upper, double lower) { steps_.insert({upper, lower}); }

 private:
  std::set<std::pair<double, double>> steps_;
};

class Scan {
 public:
  Scan(const Params& p, const Problem& problem, Context& context, double separation)
      : p_(p),
        problem_(problem),
        context_(context),
        separation_(separation),
        connector_(problem),
        lines_(tracking_lines(problem.configuration_space(), separation, 1e-6 * problem.robot().tool_width, p.delta_x)),
        places_(places_of(lines_)),
        left_(places_),
        on_line_(lines_.first.size() - 1),
        steps_(lines_.first.size() - 1),
        path_(problem.start()) {
    if (p.nearest == "way") by_path_.emplace(problem);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const TrackingPoint& t = lines_.points[i];
      if (p.passes == "alternate" && !met(t)) {
        left_.remove(i);
        continue;
      }
      on_line_[static_cast<std::size_t>(t.line)].insert({t.at.x(), i});
      if (by_path_) by_path_->add(t.at, static_cast<int>(i), i);
    }
  }

  Path run() {
    const std::size_t all = left_.remaining();
    if (all == 0) throw Infeasible("no sweep line has a tracking point; a smaller separation or delta_x may give some");
    std::size_t at = on_line_first();
    const Polyline way = connector_.path(path_.at(), places_[at]);
    path_.drive(way, false);
    for (std::size_t done = 1; done < all && !context_.cancelled(); ++done) {
      track(at);
      at = go_on(at);
      context_.progress(static_cast<double>(done) / static_cast<double>(all));
    }
    report(all);
    return path_.take();
  }

 private:
  static std::vector<Point> places_of(const TrackingLines& lines) {
    std::vector<Point> all;
    for (const TrackingPoint& t : lines.points) all.push_back(t.at);
    return all;
  }
  /// Passes to the right meet the left wall first, then right contacts; passes to the left only left contacts.
  static bool met(const TrackingPoint& t) {
    return t.line % 2 == 0 ? !is_left(t.status) || t.status == Contact::left_wall : is_left(t.status);
  }
  std::size_t on_line_first() const {
    for (const auto& line : on_line_)
      if (!line.empty()) return line.begin()->second;
    return 0;
  }
  const TrackingPoint& point(std::size_t i) const { return lines_.points[i]; }
  bool tracked(std::size_t i) const { return !on_line_[line_of(i)].contains({places_[i].x(), i}); }
  std::size_t line_of(std::size_t i) const { return static_cast<std::size_t>(point(i).line); }
  void track(std::size_t i) {
    on_line_[line_of(i)].erase({places_[i].x(), i});
    left_.remove(i);
    if (by_path_) by_path_->remove(static_cast<int>(i));
  }

  /// Drives to the next point, by the rules.
  std::size_t go_on(std::size_t at) {
    if (p_.rules == "literal") {
      for (const int by : {0, 1, -1})
        if (const auto next = nearest_on(at, by); next && connector_.straight(places_[at], places_[*next]))
          return link(*next, {places_[at], places_[*next]});
    } else {
      if (!tracked(at ^ 1)) return link(at ^ 1, {places_[at], places_[at ^ 1]});  // the own interval's other end
      for (const int by : {direction_, -direction_}) {
        const auto next = nearest_on(at, by);
        if (!next) continue;
        const Polyline way = step(at, *next);
        if (way.empty()) continue;
        direction_ = by;
        return link(*next, way);
      }
    }
    return jump(at);
  }

  /// The nearest untracked point of the line so many onwards that the rules ask for.
  std::optional<std::size_t> nearest_on(std::size_t at, int by) const {
    const int line = point(at).line + by;
    if (line < 0 || line >= static_cast<int>(on_line_.size())) return std::nullopt;
    const auto& left = on_line_[static_cast<std::size_t>(line)];
    std::optional<std::size_t> best;
    const double x = places_[at].x();
    const auto look = [&](std::size_t i) {
      if (p_.rules == "literal" && !wanted(point(at), point(i))) return false;
      if (!best || std::abs(places_[i].x() - x) < std::abs(places_[*best].x() - x)) best = i;
      return true;
    };
    const auto middle = left.lower_bound({x, 0});
    for (auto i = middle; i != left.end() && !look(i->second);) ++i;
    for (auto i = middle; i != left.begin() && !look((--i)->second);) {}
    return best;
  }
  static bool wanted(const TrackingPoint& from, const TrackingPoint& to) {
    if (from.obstacle == 0) return is_left(from.status) != is_left(to.status);
    return is_left(from.status) == is_left(to.status) && from.obstacle == to.obstacle;
  }

  /// A way to a point of a neighbouring line that crosses no earlier one, and is then taken: straight, or along one of the
  /// two lines and straight across. Empty if there is none.
  Polyline step(std::size_t from, std::size_t to) {
    const Point &a = places_[from], &b = places_[to];
    const Polyline straight{a, b}, across_first{a, {a.x(), b.y()}, b}, along_first{a, {b.x(), a.y()}, b};
    const bool same_side = is_left(point(from).status) == is_left(point(to).status);
    const std::array<const Polyline*, 3> ways = same_side ? std::array{&straight, &across_first, &along_first}
                                                          : std::array{&across_first, &along_first, &straight};
    Steps& steps = steps_[static_cast<std::size_t>(std::min(point(from).line, point(to).line))];
    for (const Polyline* way : ways) {
      double upper = way == &along_first ? b.x() : a.x(), lower = way == &across_first ? a.x() : b.x();
      if (point(from).line > point(to).line) std::swap(upper, lower);
      bool free = steps.fits(upper, lower);
      for (std::size_t i = 1; free && i < way->size(); ++i) free = connector_.straight((*way)[i - 1], (*way)[i]);
      if (!free) continue;
      steps.add(upper, lower);
      return *way;
    }
    return {};
  }

  std::size_t link(std::size_t to, const Polyline& way) {
    links_.push_back(way);
    path_.drive(way, true);
    return to;
  }

  std::size_t jump(std::size_t from) {
    std::size_t to = from;
    std::optional<Polyline> shortest;
    if (by_path_)
      if (auto found = by_path_->from(places_[from])) {
        to = found->id;
        shortest = std::move(found->path);
      }
    if (to == from)
      left_.visit(places_[from], [&](std::size_t i, double) {
        to = i;
        return false;
      });
    if (std::abs(point(from).line - point(to).line) == 1 &&
        distance(places_[from], places_[to]) <= problem_.robot().tool_width)
      if (const Polyline way = step(from, to); !way.empty()) return link(to, way);
    if (connector_.straight(places_[from], places_[to])) return drive_off({places_[from], places_[to]}, to);
    ++planned_;
    std::optional<Polyline> way;
    if (p_.transit == "tlppa") {
      if (!tlppa_) tlppa_ = std::make_unique<Tlppa>(problem_, p_.cell_size > 0 ? p_.cell_size : separation_ / 2);
      way = tlppa_->path(places_[from], places_[to]);
      if (!way) ++failed_;
    }
    if (!way) way = shortest ? std::move(*shortest) : connector_.path(places_[from], places_[to]);
    planned_paths_.push_back(*way);
    return drive_off(*way, to);
  }
  std::size_t drive_off(const Polyline& way, std::size_t to) {
    path_.drive(way, false);
    transits_.push_back(way);
    return to;
  }

  void report(std::size_t all) {
    const LinkCrossings crossings = count_crossings(links_, transits_);
    context_.record("tracking_points", static_cast<double>(all));
    context_.record("links_planned", static_cast<double>(planned_));
    context_.record("links_crossing", static_cast<double>(crossings.links));
    context_.record("transits_crossing", static_cast<double>(crossings.transits));
    if (p_.transit == "tlppa") context_.record("tlppa_failed", static_cast<double>(failed_));
    if (!context_.wants_traces()) return;
    std::vector<Polyline> marks;
    const double r = separation_ / 8;
    for (const TrackingPoint& t : lines_.points)
      marks.push_back(
          {t.at + Point(-r, -r), t.at + Point(r, -r), t.at + Point(r, r), t.at + Point(-r, r), t.at + Point(-r, -r)});
    context_.trace("tracking-points", std::move(marks));
    context_.trace("planned-links", planned_paths_);
  }

  const Params& p_;
  const Problem& problem_;
  Context& context_;
  double separation_;
  Connector connector_;
  TrackingLines lines_;
  std::vector<Point> places_;
  PointGrid left_;  // untracked
  std::optional<NearestComponent> by_path_;
  std::vector<std::set<std::pair<double, std::size_t>>> on_line_;  // untracked, from left to right
  std::vector<Steps> steps_;                                       // below each line
  std::unique_ptr<Tlppa> tlppa_;
  int direction_ = 1;
  PathBuilder path_;
  std::vector<Polyline> links_, transits_, planned_paths_;
  std::size_t planned_ = 0, failed_ = 0;
};

class Hyun final : public CoveragePlanner {
 public:
  explicit Hyun(Params p) : p_(std::move(p)) {}

  Path plan(const Problem& problem, Context& context) const override {
    const double tool = problem.robot().tool_width, robot = height(problem.robot());
    const double separation = p_.separation > 0 ? p_.separation : (robot > 0 ? std::min(robot, tool) : tool) / 2;
    const double lines = bounding_box(problem.configuration_space()).size().y() / separation;
    if (lines > kMostLines)
      throw std::invalid_argument(
          fmt::format("planner 'hyun': separation {} m makes {:.0f} sweep lines, expected at most "
                      "{}; a larger separation or a wider tool mends it",
                      separation, lines, kMostLines));
    Path path = Scan(p_, problem, context, separation).run();
    if (!p_.outline || context.cancelled()) return path;
    context.publish(path);
    return with_outline(problem, path, tool, Connector(problem), context);
  }

 private:
  Params p_;
};

}  // namespace

PlannerInfo hyun() {
  return describe<Hyun, Params>(
      {.name = "hyun",
       .family = "grid",
       .title = "heuristic sweep from contact to contact",
       .citation = "Hyun, heuristic sweeping algorithm",
       .capabilities = {Capability::holes, Capability::footprint},
       .guarantee = "both ends of every free stretch of every sweep line once; links with the tool on never cross",
       .parameters = {
           {"separation", &Params::separation, Range{0, 1000},
            "between sweep lines, metres; 0: half the width of the robot, or of the tool if that is less"},
           {"delta_x", &Params::delta_x, Range{0, 1000}, "contacts on a raster so fine, metres; 0: exact"},
           {"passes", &Params::passes, Choices{"both", "alternate"},
            "both: contacts at both ends; alternate: as printed, those of one side on each line"},
           {"rules", &Params::rules, Choices{"resolved", "literal"},
            "resolved: back and forth (see the file); literal: as printed"},
           {"nearest", &Params::nearest, Choices{"air", "way"}, "of all that is left: as the crow flies, or by way"},
           {"transit", &Params::transit, Choices{"tlppa", "visibility"},
            "where the straight way is blocked: two-level grid search, or the shortest path"},
           {"cell_size", &Params::cell_size, Range{0, 1000}, "fine cell of tlppa, metres; 0: half the separation"},
           {"outline", &Params::outline, "also drive the border of configuration space"}}});
}

}  // namespace oxturn
