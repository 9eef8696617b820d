// Complexity  A path that the plain shortest path gives: that path, and a simulation of the tether along it unless both
//             together are within the limit. Otherwise up to `budget` expansions of the search for other classes, and a
//             simulation for each bend that it tries.
// Decisions   1. The tether is checked at the ends of a path's segments: on a straight segment its length is convex
//                (the universal cover of free space has no positive curvature), so it is longest at an end.
//             2. If the tether is too short at a bend of a path, it is for every path with that prefix. The search
//                prunes such prefixes, and so ends although there are infinitely many classes.
//             3. On the best path of a class the tether of a point robot is never longer than at both ends. For a disc,
//                rounding may violate the limit in between, since its space's arcs are polygons: such a path is
//                rejected.
//             4. If the class of the geodesic violates the limit when pulled taut, it is driven as it is: back to where
//                the path from the start to the goal leaves the path driven, then from there.
//             5. `untangle` tries to leave the path back at its vertices and at 64 or more points between them, then
//                bisects the last step ten times. Where the goal cannot be reached straight from anywhere, which
//                Xavier's text leaves open, the path is that of decision 4: by the start, each cell of a spiral would
//                cost twice the tether.
//             6. The path to a goal outside the cut space follows the goal's geodesic from its last point in the cut
//                space (or to which the caller knows a path) on. Where the robot cannot be on the geodesic it takes
//                the shortest path of the same class to the next point of it where it can. These searches are local,
//                so their cost does not grow with the number of classes of the whole map. The result is pulled taut.
//             7. Points are driven together, a few at a time, if no corner lies in a triangle that holds them and the
//                robot.
//             8. For a goal outside the cut space the search has no bound on the path's length. If the budget does not
//                suffice, the path is that of decision 4 along the caller's path out, or, if there is none, leads back
//                to the start and from there follows the class of the geodesic.
#include "geometry/tether/tethered_path.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/throw_invalid.hpp"
#include "geometry/tether/branching_tether.hpp"
#include "geometry/tether/straightened.hpp"

namespace oxturn {

TetheredWorld::TetheredWorld(const TautSpace& free_space, const EdgeIndex& robot_walls, const Region& robot_space,
                             ShortestPaths robot_paths, ShortestPaths geodesic_paths, const GeodesicField& geodesics,
                             double tether_length, double rounding)
    : free(free_space),
      space(robot_space),
      walls(robot_walls),
      paths(std::move(robot_paths)),
      cut_paths(std::move(geodesic_paths)),
      field(geodesics),
      longest(tether_length),
      tolerance(rounding) {
  if (!(longest >= 0)) throw_invalid("a tether must be 0 or more metres long");
}

Polyline pulled_taut(const TetheredWorld& world, const Polyline& line) {
  TautTether tether(world.space, line.front());
  tether.drive(line);
  return tether.polyline();
}

namespace {

/// Does the tether keep its length limit along `points`, which begin where its robot is?
bool admissible(const TetheredWorld& world, const TautTether& from, const Polyline& points) {
  return from.length() + length(points) <= world.longest ||  // it grows by what is driven, at most
         stays_within(from, std::span(points).subspan(1), world.longest + world.tolerance);
}

Polyline reversed(Polyline line) {
  std::reverse(line.begin(), line.end());
  return line;
}

Polyline joined(Polyline first, const Polyline& second) {
  first.insert(first.end(), second.begin() + (first.back() == second.front() ? 1 : 0), second.end());
  return first;
}

/// The same as tether.drive(points).
void drive_together(TautTether& tether, const TautSpace& corners, const Polyline& points) {
  constexpr std::size_t kAlone = 4;  // points, where none can be skipped
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (const std::size_t skipped = points_to_skip(corners, tether.robot(), points, i); skipped > 0)
      i += skipped;
    else
      for (const std::size_t last = std::min(i + kAlone, points.size()) - 1; i < last; ++i) tether.drive(points[i]);
    tether.drive(points[i]);
  }
}

/// Back along the trail to where a path from the start leaves it, at the latest at the start, then along that path.
Polyline back_and_out(const TetheredWorld& world, const TautTether& trail, const Polyline& out) {
  const Polyline driven = trail.polyline();
  std::size_t shared = 1;  // points
  while (shared < std::min(driven.size(), out.size()) && distance(driven[shared], out[shared]) <= world.tolerance)
    ++shared;
  const auto leave = static_cast<std::ptrdiff_t>(shared) - 1;
  return joined(reversed({driven.begin() + leave, driven.end()}), {out.begin() + leave, out.end()});
}
/// The same pulled taut, or else as it is; nullopt: neither keeps the tether length limit.
std::optional<Polyline> shortest_back_and_out(const TetheredWorld& world, const TautTether& tether,
                                              const TautTether& trail, const Polyline& out) {
  const Polyline line = back_and_out(world, trail, out);
  if (Polyline taut = pulled_taut(world, line); admissible(world, tether, taut)) return taut;
  return admissible(world, tether, line) ? std::optional(line) : std::nullopt;
}

/// Back along the trail until the goal can be reached straight (Xavier 1999).
class Untangling {
 public:
  Untangling(const TetheredWorld& world, const TautTether& tether, const TautTether& trail, const Point& goal)
      : world_(world), tether_(tether), back_(reversed(trail.polyline())), goal_(goal) {}

  /// nullopt if the goal can be reached straight from no point tried.
  std::optional<Polyline> run() {
    TautTether here = tether_;  // at back_[k - 1]
    if (auto path = leave(here, back_.front(), {})) return path;
    const double step = length(back_) / kSteps;
    for (std::size_t k = 1; k < back_.size(); ++k) {
      const Polyline driven(back_.begin(), back_.begin() + static_cast<std::ptrdiff_t>(k));
      const Point &a = back_[k - 1], &b = back_[k];
      const int parts = step > 0 ? std::max(1, static_cast<int>(std::ceil(distance(a, b) / step))) : 1;
      for (int i = 1; i <= parts; ++i)
        if (auto path = leave(here, i == parts ? b : lerp(a, b, double(i) / parts), driven)) {
          const double last = double(i - 1) / parts, found = double(i) / parts;
          return earliest(here, a, b, driven, last, found, std::move(path));
        }
      here.drive(b);
    }
    return std::nullopt;
  }

 private:
  static constexpr int kSteps = 64, kBisections = 10;

  /// Along `driven` to p, from there straight to the goal. `from` is at the last point of `driven`.
  std::optional<Polyline> leave(TautTether from, const Point& p, Polyline driven) const {
    if (!world_.walls.contains(p, goal_)) return std::nullopt;
    from.drive(p);
    from.drive(goal_);
    if (world_.too_long(from)) return std::nullopt;
    driven.push_back(p);
    driven.push_back(goal_);
    if (!admissible(world_, tether_, driven)) return std::nullopt;
    return driven;
  }
  /// The earliest point to leave ab, between `bad` and `good`, where `best` leaves it.
  std::optional<Polyline> earliest(const TautTether& here, const Point& a, const Point& b, const Polyline& driven,
                                   double bad, double good, std::optional<Polyline> best) const {
    for (int k = 0; k < kBisections; ++k) {
      const double middle = (bad + good) / 2;
      auto earlier = leave(here, lerp(a, b, middle), driven);
      (earlier ? good : bad) = middle;
      if (earlier) best = std::move(earlier);
    }
    return best;
  }

  const TetheredWorld& world_;
  const TautTether& tether_;
  const Polyline back_;
  const Point goal_;
};

/// `taut`, a taut line of the robot's space, followed by `more`, pulled taut. Looks at as many of the last vertices as
/// it takes to leave one bend as it is.
Polyline extended_taut(const TetheredWorld& world, const Polyline& taut, const Polyline& more) {
  constexpr std::size_t kFirstTried = 2;  // segments
  for (std::size_t tried = kFirstTried;; tried *= 4) {
    const std::size_t kept = taut.size() > tried + 1 ? taut.size() - 1 - tried : 0;
    const auto begin = taut.begin() + static_cast<std::ptrdiff_t>(kept);
    TautTether tether(world.space, *begin);
    for (auto p = begin + 1; p != taut.end(); ++p) tether.drive(*p);
    tether.drive(more);
    // The line's vertices may be rounded: those of a space that has been cut open are.
    if (kept > 0 && (tether.bends().empty() || distance(tether.bends().front().at, taut[kept + 1]) > world.tolerance))
      continue;
    Polyline whole(taut.begin(), begin);
    std::ranges::copy(tether.polyline(), std::back_inserter(whole));
    return whole;
  }
}

/// The robot's shortest path without regard to the tether. Nothing is nearer to one end than by how much the other's
/// distance from the anchor is greater, so the search from the end that is farther away keeps near the geodesics.
std::optional<Polyline> shortest(const TetheredWorld& world, const Point& from, const Point& to) {
  if (world.walls.contains(from, to)) return Polyline{from, to};
  const double a = world.field.distance(from), b = world.field.distance(to), least = std::min(a, b);
  const auto to_end = [&](const Point& p) {
    const double d = world.field.distance(p) - least;
    return std::isfinite(d) ? std::max(d, 0.0) : 0.0;
  };
  const double longest = std::numeric_limits<double>::infinity();
  if (a > b) return world.paths.path(from, to, longest, to_end);
  auto path = world.paths.path(to, from, longest, to_end);
  if (path) std::reverse(path->begin(), path->end());
  return path;
}

/// The last part of a tether that lies along a geodesic: moving it does not cost all bends of the geodesic.
class TetherEnd {
 public:
  /// At p, with so many segments at most.
  TetherEnd(const TetheredWorld& world, const Point& p, std::size_t segments)
      : TetherEnd(world, world.field.path(p), segments) {}

  void drive(const Point& to) { tether_.drive(to); }
  double length() const { return before_ + tether_.length(); }  // metres, from the anchor
  /// False once the tether may have changed before that part.
  bool known() const { return !bend_ || (!tether_.bends().empty() && tether_.bends().front().at == *bend_); }

 private:
  TetherEnd(const TetheredWorld& world, const Polyline& geodesic, std::size_t segments)
      : TetherEnd(world, geodesic, geodesic.begin() + beginning(geodesic.size(), segments)) {}
  TetherEnd(const TetheredWorld& world, const Polyline& geodesic, Polyline::const_iterator begin)
      : before_(oxturn::length(Polyline(geodesic.begin(), begin + (begin != geodesic.end() ? 1 : 0)))),
        tether_(world.free, begin != geodesic.end() ? *begin : world.field.anchor()) {
    if (begin != geodesic.begin()) bend_ = *(begin + 1);
    for (auto p = begin; p != geodesic.end(); ++p) tether_.drive(*p);
  }
  static std::ptrdiff_t beginning(std::size_t points, std::size_t segments) {
    return points > segments + 1 ? static_cast<std::ptrdiff_t>(points - 1 - segments) : 0;
  }

  double before_;  // metres, to where the part begins
  TautTether tether_;
  std::optional<Point> bend_;  // the first one; none if the part is all of the tether
};

/// See geodesic_path().
using KnownPaths = std::function<std::optional<Polyline>(const Point&)>;

/// Follows the goal's geodesic, and where the robot cannot be on it, goes round by the shortest path of the same class.
class GeodesicFollower {
 public:
  /// So many of the geodesic's last segments are looked at.
  GeodesicFollower(const TetheredWorld& world, const Point& start, const Point& goal, double slack,
                   const KnownPaths& known, std::size_t budget, std::size_t segments)
      : world_(world),
        known_(known),
        start_(start),
        goal_(goal),
        slack_(slack),
        budget_(budget),
        segments_(segments),
        tether_(world, start, 1) {}

  std::optional<Polyline> run() {
    join();
    const Polyline inside = line_;
    line_.erase(line_.begin(), line_.end() - 1);
    for (std::size_t next = 0; next < samples_.size();) {
      const auto reached = advance(next);
      if (!reached) return std::nullopt;
      next = *reached + 1;
    }
    Polyline taut = extended_taut(world_, inside, line_);
    const auto differ = std::mismatch(taut.begin(), taut.end(), inside.begin(), inside.end()).first;
    const auto last_known = static_cast<std::size_t>(differ - taut.begin()) - 1;
    return is_geodesic(tether_at(taut[last_known]), taut, last_known) ? taut : joined(inside, line_);
  }

  /// Were more of the geodesic's segments needed? Then the result says nothing.
  bool needs_more() const { return needs_more_; }

 private:
  static constexpr double kStepsPerSlack = 24;

  /// By how much the tether is longer than the geodesic along a line: at most, and at the line's end.
  struct Excess {
    double most = 0, last = 0;
  };
  /// The tether is that given at the line's point `first`.
  Excess excess(TetherEnd tether, const Polyline& line, std::size_t first = 0) const {
    Excess e;
    for (std::size_t k = first + 1; k < line.size(); ++k) {
      tether.drive(line[k]);
      needs_more_ = needs_more_ || !tether.known();
      e.last = tether.length() - world_.field.distance(line[k]);
      e.most = std::max(e.most, e.last);
    }
    return e;
  }
  TetherEnd tether_at(const Point& p) const { return {world_, p, segments_}; }
  bool is_geodesic(const TetherEnd& tether, const Polyline& line, std::size_t first = 0) const {
    const Excess e = excess(tether, line, first);
    return e.most <= slack_ && e.last <= world_.tolerance;
  }
  void drive(const Polyline& line) {
    for (const Point& p : line) tether_.drive(p);
    line_ = joined(std::move(line_), line);
  }

  /// To the last point of the goal's geodesic to which a path is known. Samples are those after it.
  void join() {
    const Polyline geodesic = world_.field.path(goal_);
    const double step = slack_ / kStepsPerSlack;
    for (std::size_t k = geodesic.size(); k-- > 1;) {
      const double n = std::max(1.0, std::ceil(distance(geodesic[k - 1], geodesic[k]) / step));
      for (double i = n; i >= (k == 1 ? 0 : 1); --i) {
        const Point sample = samples_.empty() ? goal_ : lerp(geodesic[k - 1], geodesic[k], i / n);
        if (auto path = known_(sample)) {
          line_ = std::move(*path);
          tether_ = tether_at(sample);
          std::reverse(samples_.begin(), samples_.end());
          return;
        }
        samples_.push_back(sample);
      }
    }
    std::reverse(samples_.begin(), samples_.end());
    line_ = {start_};
    tether_ = tether_at(start_);
  }
  /// To the first sample from `next` on that can be reached; nullopt: none.
  std::optional<std::size_t> advance(std::size_t next) {
    for (; next < samples_.size(); ++next) {
      const Point& to = samples_[next];
      const bool last = next + 1 == samples_.size();
      if (!last && !world_.walls.contains(to)) continue;
      const Polyline straight{line_.back(), to};
      if (world_.walls.contains(line_.back(), to) && is_geodesic(tether_, straight)) {
        drive(straight);
        return next;
      }
      if (const auto round = shortest_of_class(to)) {
        drive(*round);
        return next;
      }
    }
    return std::nullopt;
  }
  std::optional<Polyline> shortest_of_class(const Point& to) const {
    std::optional<Polyline> found;
    world_.paths.for_each_taut_path(
        line_.back(), to, std::numeric_limits<double>::infinity(), budget_,
        [&](const Polyline& line) {
          if (is_geodesic(tether_, line)) found = line;
          return !found;
        },
        [&](const Polyline& prefix) { return excess(tether_, prefix).most <= slack_; });
    return found;
  }

  const TetheredWorld& world_;
  const KnownPaths& known_;
  const Point start_, goal_;
  const double slack_;
  const std::size_t budget_, segments_;
  Polyline samples_;  // of the goal's geodesic, after the last point to which a path is known
  TetherEnd tether_;  // at the end of line_
  Polyline line_;     // from that point on
  mutable bool needs_more_ = false;
};

}  // namespace

std::optional<Polyline> geodesic_path(const TetheredWorld& world, const Point& start, const Point& goal, double slack,
                                      std::size_t budget) {
  return geodesic_path(
      world, start, goal, slack, [&](const Point& p) { return world.cut_paths.path(start, p); }, budget);
}
std::optional<Polyline> geodesic_path(const TetheredWorld& world, const Point& start, const Point& goal, double slack,
                                      const KnownPaths& known, std::size_t budget) {
  if (auto path = known(goal)) return path;
  constexpr std::size_t kFirstTried = 8, kMore = 16;  // segments, and times as many
  for (std::size_t segments = kFirstTried;; segments *= kMore) {
    GeodesicFollower follower(world, start, goal, slack, known, budget, segments);
    auto path = follower.run();
    if (!follower.needs_more()) return path;
  }
}

bool within_tether(const TetheredWorld& world, const Polyline& path) {
  if (world.field.distance(path.front()) + length(path) <= world.longest) return true;  // it grows by what is driven
  constexpr std::size_t kFirstTried = 8, kMore = 16;  // segments of the geodesic, and times as many
  for (std::size_t segments = kFirstTried;; segments *= kMore) {
    TetherEnd tether(world, path.front(), segments);
    bool kept = true;
    for (std::size_t k = 1; k < path.size() && kept && tether.known(); ++k) {
      tether.drive(path[k]);
      kept = tether.length() <= world.longest + world.tolerance;
    }
    if (tether.known()) return kept;
  }
}

TetheredRobot::TetheredRobot(const TetheredWorld& world, const Point& start)
    : world_(&world), tether_(world.free, world.field.anchor()), trail_(world.space, start) {
  const Polyline out = world.field.path(start);
  if (out.empty())
    throw_invalid("start ({}, {}) is out of reach of the tether's anchor ({}, {})", start.x(), start.y(),
                  tether_.anchor().x(), tether_.anchor().y());
  tether_.drive(out);
}

std::optional<TetheredPath> TetheredRobot::path_to(const Point& goal, Retraction retraction, std::size_t budget) const {
  const TetheredWorld& world = *world_;
  if (retraction == Retraction::automatic && tether_.length() + distance(at(), goal) <= world.longest &&
      world.walls.contains(at(), goal))
    return TetheredPath{{at(), goal}};
  if (!(world.field.distance(goal) <= world.longest + world.tolerance)) return std::nullopt;
  if (retraction == Retraction::untangle) {
    if (auto path = Untangling(world, tether_, trail_, goal).run()) return TetheredPath{std::move(*path)};
    if (const auto out = world.cut_paths.path(trail_.anchor(), goal))
      if (Polyline line = back_and_out(world, trail_, *out); admissible(world, tether_, line))
        return TetheredPath{std::move(line)};
    return path_by_start(goal, budget);
  }
  const auto plain = shortest(world, at(), goal);
  if (!plain) return std::nullopt;
  if (admissible(world, tether_, *plain)) return TetheredPath{*plain};

  std::optional<Polyline> best;
  if (const auto out = world.cut_paths.path(trail_.anchor(), goal))
    best = shortest_back_and_out(world, tether_, trail_, *out);
  const double bound = best ? length(*best) : std::numeric_limits<double>::infinity();
  bool found = false;
  BranchingTether branches(tether_, world.longest + world.tolerance);
  const bool all = world.paths.for_each_taut_path(
      at(), goal, bound, budget,
      [&](const Polyline& line) {
        found = branches.stays_within(line);
        if (found) best = line;
        return !found;
      },
      [&](const Polyline& prefix) { return branches.stays_within(prefix); });
  if (best) return TetheredPath{std::move(*best), found || all};
  if (all) return std::nullopt;
  if (world.path_out)
    if (const auto out = world.path_out(goal))
      if (auto line = shortest_back_and_out(world, tether_, trail_, *out)) return TetheredPath{std::move(*line), false};
  return path_by_start(goal, budget);
}

/// Back to the start and on from there: where nothing else has led to the goal.
std::optional<TetheredPath> TetheredRobot::path_by_start(const Point& goal, std::size_t budget) const {
  if (at() == trail_.anchor()) {
    const double longest = std::min(world_->longest, world_->field.farthest());
    for (double slack = longest / 64; slack <= longest; slack *= 4)
      if (auto out = geodesic_path(*world_, at(), goal, slack); out && admissible(*world_, tether_, *out))
        return TetheredPath{std::move(*out), false};
    return std::nullopt;
  }
  const Polyline back = reversed(trail_.polyline());
  TetheredRobot home = *this;
  home.drive(back);
  const auto out = home.path_to(goal, Retraction::automatic, budget);
  if (!out) return std::nullopt;
  Polyline line = joined(back, out->points);
  if (!admissible(*world_, tether_, line)) return std::nullopt;
  return TetheredPath{std::move(line), false};
}

std::optional<Polyline> TetheredRobot::path_home() const {
  Polyline back = reversed(trail_.polyline());
  if (!admissible(*world_, tether_, back)) return std::nullopt;
  return back;
}

void TetheredRobot::drive(const Polyline& points) {
  drive_together(tether_, world_->free, points);
  drive_together(trail_, world_->space, points);
}

}  // namespace oxturn
