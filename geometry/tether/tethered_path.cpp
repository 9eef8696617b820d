// Ways for a robot on a leash: one class after another, by length, until the string holds.
//
// Complexity  a way that the plain shortest path gives: that path and a simulation of the string along it; else up to
//             `budget` expansions of the search for other classes, and a simulation for each bend that it tries
// Decisions   1. The string is checked at the ends of a way's segments: on a straight one its length is convex (the
//                universal cover of free space has no positive curvature), so it is longest at an end.
//             2. What the string does not reach at a bend of a way it does not reach for any way that begins so: the
//                search leaves such beginnings out, and so ends although there are endlessly many classes.
//             3. On the best way of a class the string of a point robot is never longer than at both ends. For a disc
//                rounding (its space's arcs are polygons) may breach the leash in the middle: such a way does not count.
//             4. If the class of the geodesic breaks the leash when pulled taut, it is driven as it comes: back to the
//                start, then from there.
//             5. `untangle` looks for the place to leave the way back at its corners and at 64 or more places between,
//                then halves the last step ten times.
//             6. The way to a goal outside the cut space is looked for from the last place of the goal's geodesic where
//                the robot can stand, and pulled taut; if that is not it, from the start.
//             7. A goal outside the cut space has no such bound: if the budget does not do, back to the start and from
//                there by the class of the geodesic, looked for among ways along which the string is little longer.
#include "geometry/tether/tethered_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geometry/edge_index.hpp"

namespace oxturn {

struct TetheredWorld::Impl {
  TautSpace free, space;
  EdgeIndex walls;
  ShortestPaths paths, cut_paths;
  const GeodesicField& field;
  double longest, tolerance;
};

TetheredWorld::TetheredWorld(const Region& free, const Region& space, const Region& cut_space,
                             const GeodesicField& field, double longest, double tolerance) {
  if (!(longest >= 0)) throw std::invalid_argument("a leash must be 0 or more metres long");
  impl_.reset(new Impl{TautSpace(free), TautSpace(space), EdgeIndex(space), ShortestPaths(space, tolerance),
                       ShortestPaths(cut_space, tolerance), field, longest, tolerance});
}
TetheredWorld::~TetheredWorld() = default;

namespace {

using Way = TetheredRobot::Way;

/// `points` as a way from where `string` is; nullopt if the string gets longer than the leash.
std::optional<Way> checked(const TetheredWorld::Impl& world, TautTether string, Polyline points) {
  Way way;
  way.tether_max = string.length();
  for (std::size_t k = 1; k < points.size(); ++k) {
    string.drive(points[k]);
    if (string.length() > world.longest + world.tolerance) return std::nullopt;
    way.tether_max = std::max(way.tether_max, string.length());
  }
  way.tether_end = string.length();
  way.points = std::move(points);
  return way;
}

Polyline reversed(Polyline line) {
  std::reverse(line.begin(), line.end());
  return line;
}

Polyline joined(Polyline first, const Polyline& second) {
  first.insert(first.end(), second.begin() + (first.back() == second.front() ? 1 : 0), second.end());
  return first;
}

Polyline taut(const TautSpace& space, const Polyline& line) {
  TautTether string(space, line.front());
  string.drive(line);
  return string.polyline();
}

/// From `string`'s robot to the goal in the class of the geodesic: back along `shadow` to the start, then through the
/// cut space. nullopt if the goal is no part of that.
std::optional<Way> path_of_geodesic(const TetheredWorld::Impl& world, const TautTether& string, const TautTether& shadow,
                                   const Point& goal, bool pulled) {
  const auto out = world.cut_paths.path(shadow.anchor(), goal);
  if (!out) return std::nullopt;
  const Polyline whole = joined(reversed(shadow.polyline()), *out);
  if (pulled)
    if (auto way = checked(world, string, taut(world.space, whole))) return way;
  return checked(world, string, whole);
}

/// Back along `shadow` until `goal` is in straight reach.
std::optional<Way> path_untangled(const TetheredWorld::Impl& world, const TautTether& string, const TautTether& shadow,
                                 const Point& goal) {
  const Polyline back = reversed(shadow.polyline());
  const double step = length(back) / 64;
  TautTether here = string;  // at back[k - 1]
  const auto leave = [&](TautTether from, const Point& place, Polyline driven) -> std::optional<Way> {
    if (!world.walls.contains(place, goal)) return std::nullopt;
    from.drive(place);
    from.drive(goal);
    if (from.length() > world.longest + world.tolerance) return std::nullopt;
    driven.push_back(place);
    driven.push_back(goal);
    return checked(world, string, std::move(driven));
  };
  if (auto way = leave(here, back.front(), {})) return way;
  for (std::size_t k = 1; k < back.size(); ++k) {
    const Polyline driven(back.begin(), back.begin() + static_cast<std::ptrdiff_t>(k));
    const Point &a = back[k - 1], &b = back[k];
    const int parts = step > 0 ? std::max(1, static_cast<int>(std::ceil(distance(a, b) / step))) : 1;
    for (int i = 1; i <= parts; ++i) {
      auto way = leave(here, i == parts ? b : lerp(a, b, double(i) / parts), driven);
      if (!way) continue;
      double bad = double(i - 1) / parts, good = double(i) / parts;
      for (int halving = 0; halving < 10; ++halving) {
        const double middle = (bad + good) / 2;
        auto earlier = leave(here, lerp(a, b, middle), driven);
        (earlier ? good : bad) = middle;
        if (earlier) way = std::move(earlier);
      }
      return way;
    }
    here.drive(b);
  }
  return path_of_geodesic(world, string, shadow, goal, false);
}

/// Along `line` from where `string` is: by how much the string is longer than the geodesic, at most and at the end.
std::pair<double, double> excess(const TetheredWorld::Impl& world, TautTether string, const Polyline& line) {
  double most = 0, last = 0;
  for (std::size_t k = 1; k < line.size(); ++k) {
    string.drive(line[k]);
    last = string.length() - world.field.distance(line[k]);
    most = std::max(most, last);
  }
  return {most, last};
}

/// Through the cut space to the last place on the goal's geodesic (looked for in steps of `step`) that is part of it.
std::optional<Polyline> path_towards(const TetheredWorld::Impl& world, const Point& start, const Point& goal,
                                    double step) {
  const Polyline string = world.field.path(goal);
  for (std::size_t k = string.size(); k-- > 1;) {
    const double n = std::ceil(distance(string[k - 1], string[k]) / step);
    for (double i = 1; i <= n; ++i)
      if (auto way = world.cut_paths.path(start, lerp(string[k], string[k - 1], i / n))) return way;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Polyline> geodesic_path(const TetheredWorld& world, const Point& start, const Point& goal, double slack,
                                     std::size_t budget) {
  const TetheredWorld::Impl& w = world.impl();
  if (auto inside = w.cut_paths.path(start, goal)) return inside;
  const auto search = [&](const Point& from) {
    TautTether at_from(w.free, w.field.anchor());
    at_from.drive(w.field.path(from));
    std::optional<Polyline> found;
    w.paths.for_each_taut_path(
        from, goal, std::numeric_limits<double>::infinity(), budget,
        [&](const Polyline& line) {
          const auto [most, last] = excess(w, at_from, line);
          if (most <= slack && last <= w.tolerance) found = line;
          return !found;
        },
        [&](const Polyline& beginning) { return excess(w, at_from, beginning).first <= slack; });
    return found;
  };
  if (const auto first = path_towards(w, start, goal, slack / 24))
    if (const auto second = search(first->back())) {
      Polyline whole = taut(w.space, joined(*first, *second));
      TautTether at_start(w.free, w.field.anchor());
      at_start.drive(w.field.path(start));
      const auto [most, last] = excess(w, at_start, whole);
      if (most <= slack && last <= w.tolerance) return whole;
    }
  return search(start);
}

Polyline pulled_taut(const TetheredWorld& world, const Polyline& line) { return taut(world.impl().space, line); }

TetheredRobot::TetheredRobot(const TetheredWorld& world, const Point& start)
    : world_(&world), string_(world.impl().free, world.impl().field.anchor()), shadow_(world.impl().space, start) {
  const Polyline out = world.impl().field.path(start);
  if (out.empty())
    throw std::invalid_argument(fmt::format("start ({}, {}) is out of reach of the tether's anchor ({}, {})", start.x(),
                                            start.y(), string_.anchor().x(), string_.anchor().y()));
  string_.drive(out);
}

std::optional<TetheredRobot::Way> TetheredRobot::path_to(const Point& goal, Retraction retraction,
                                                        std::size_t budget) const {
  const TetheredWorld::Impl& world = world_->impl();
  if (!(world.field.distance(goal) <= world.longest + world.tolerance)) return std::nullopt;
  if (retraction == Retraction::untangle) {
    auto way = path_untangled(world, string_, shadow_, goal);
    return way ? way : path_by_start(goal, budget);
  }

  std::optional<Polyline> plain;
  if (world.walls.contains(at(), goal))
    plain = Polyline{at(), goal};
  else
    plain = world.paths.path(at(), goal);
  if (!plain) return std::nullopt;
  if (auto way = checked(world, string_, std::move(*plain))) return way;

  std::optional<Way> best = path_of_geodesic(world, string_, shadow_, goal, true);
  const double bound = best ? length(best->points) : std::numeric_limits<double>::infinity();
  bool found = false;
  const bool all = world.paths.for_each_taut_path(
      at(), goal, bound, budget,
      [&](const Polyline& line) {
        auto way = checked(world, string_, line);
        if (way) best = std::move(way);
        found = way.has_value();
        return !found;
      },
      [&](const Polyline& beginning) { return checked(world, string_, beginning).has_value(); });
  if (!best && !all) best = path_by_start(goal, budget);  // no bound, no end of classes
  if (best) best->shortest = found || all;
  return best;
}

std::optional<TetheredRobot::Way> TetheredRobot::path_by_start(const Point& goal, std::size_t budget) const {
  const TetheredWorld::Impl& world = world_->impl();
  std::optional<Way> way;
  if (at() == shadow_.anchor()) {
    const double longest = std::min(world.longest, world.field.farthest());
    for (double slack = longest / 64; !way && slack <= longest; slack *= 4)
      if (auto out = geodesic_path(*world_, at(), goal, slack)) way = checked(world, string_, std::move(*out));
  } else {
    const Polyline back = reversed(shadow_.polyline());
    TetheredRobot home = *this;
    home.drive(back);
    if (auto out = home.path_to(goal, Retraction::automatic, budget))
      way = checked(world, string_, joined(back, out->points));
  }
  if (way) way->shortest = false;
  return way;
}

std::optional<TetheredRobot::Way> TetheredRobot::path_home() const {
  return checked(world_->impl(), string_, reversed(shadow_.polyline()));
}

void TetheredRobot::drive(const Polyline& points) {
  for (const Point& p : points) {
    string_.drive(p);
    shadow_.drive(p);
  }
}

}  // namespace oxturn
