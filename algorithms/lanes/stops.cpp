#include "algorithms/lanes/stops.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <tuple>

#include "algorithms/lanes/flat_path.hpp"

namespace oxturn {
namespace {

constexpr double kFarthest = 2;         // reaches from a piece's centre to the path
constexpr std::size_t kMostTried = 12;  // segments of the path from which a stop is tried
constexpr int kHalvings = 30;
constexpr double kShareOfEdge = 0.499;  // that a turn may take from the segments beside it: there is one at each end
constexpr double kShareOfReach = 0.99;  // of what the turn may be cut by
constexpr double kShortest = 0.02;      // of the reach: shorter segments are of no use
constexpr double kSamePoint = 1e-9;     // of the reach
constexpr double kOnPath = 1e-5;        // of the reach: the piece's centre is on the path

bool covers(const Point& at, const Polygon& piece, double reach) {
  return std::ranges::all_of(piece.outer, [&](const Point& p) { return distance(p, at) <= reach; });
}

Point centre(const Polygon& piece) { return bounding_box(piece.outer).centre(); }

/// Of the pieces that the tool covers from there.
std::vector<Point> centres(const std::vector<Polygon>& pieces, double reach) {
  std::vector<Point> found;
  for (const Polygon& piece : pieces)
    if (covers(centre(piece), piece, reach)) found.push_back(centre(piece));
  return found;
}

}  // namespace

std::pair<Point, Point> ends_of_cut(const Stop& stop, const Polyline& path) {
  const auto towards = [&](const Point& p) { return lerp(stop.from, p, stop.cut / distance(stop.from, p)); };
  return {towards(path[*stop.turn - 1]), towards(path[*stop.turn + 1])};
}

StopFinder::StopFinder(const Polyline& path, const std::vector<bool>& tool, double reach, const EdgeIndex& walls)
    : path_(path), tool_(tool), segments_(path), reach_(reach), walls_(walls) {}

StopFinder::StopFinder(const Polyline& path, const std::vector<bool>& tool, double reach, const EdgeIndex& walls,
                       const std::vector<Polygon>& pieces)
    : path_(path),
      tool_(tool),
      segments_(path, centres(pieces, reach), kFarthest * reach),
      reach_(reach),
      walls_(walls) {}

std::optional<Stop> StopFinder::find(const Polygon& piece) const {
  const Point middle = centre(piece);
  if (!covers(middle, piece, reach_)) return std::nullopt;
  std::optional<Stop> best;
  double least = std::numeric_limits<double>::infinity();
  for (const NearbySegments::Near& near : segments_.near(middle, kFarthest * reach_, kMostTried)) {
    const Stop found = cut_short({near.segment, segments_.along(near), near.at, covering(near, middle, piece)});
    if (found.at == near.at) continue;  // a segment without length
    const double detour = length(found);
    if (detour >= least || !walls_.contains(near.at) || !walls_.contains(near.at, found.at)) continue;
    best = found;
    least = detour;
  }
  return best;
}

/// On the line from the path to the piece's centre: the positions that cover the piece are an interval of it. The tool
/// works along segments only, so where the path, with the tool off, passes the centre, the stop is a part of it or
/// leads on beyond the centre.
Point StopFinder::covering(const NearbySegments::Near& from, const Point& centre, const Polygon& piece) const {
  const double least = kShortest * reach_;
  if (from.distance < least) {
    const Point &a = path_[from.segment], &b = path_[from.segment + 1];
    const Point& end = distance(from.at, a) > distance(from.at, b) ? a : b;
    const Point& on = from.distance > kOnPath * reach_ ? centre : end;
    return on == from.at ? on : lerp(from.at, on, least / distance(from.at, on));
  }
  double outside = 0, inside = 1;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (outside + inside) / 2;
    (covers(lerp(from.at, centre, middle), piece, reach_) ? inside : outside) = middle;
  }
  return lerp(from.at, centre, std::max(inside, least / from.distance));
}

/// At a turn of the path, with the turn cut off if nothing is lost by that.
Stop StopFinder::cut_short(Stop stop) const {
  const double same = kSamePoint * reach_;
  const std::size_t v = stop.along <= same ? stop.segment : stop.segment + 1;
  const bool at_vertex = distance(stop.from, path_[v]) <= same;
  if (!at_vertex || v == 0 || v + 1 >= path_.size() || !tool_[v - 1] || !tool_[v]) return stop;
  const Point corner = path_[v], to = stop.at - corner;
  const Point before = (path_[v - 1] - corner).normalized(), after = (path_[v + 1] - corner).normalized();
  // Opposite to both segments: between their continuations.
  const double turn = cross(before, after);
  if (turn == 0 || cross(to, before) * turn < 0 || cross(after, to) * turn < 0) return stop;
  const double half_tangent = std::abs(turn) / (1 + before.dot(after));  // of half the angle between the segments
  const double cut =
      std::min({kShareOfReach * reach_ * std::min(1.0, 1 / half_tangent), kShareOfEdge * distance(corner, path_[v - 1]),
                kShareOfEdge * distance(corner, path_[v + 1])});
  if (cut < kShortest * reach_) return stop;
  if (!walls_.contains(corner + cut * before, stop.at) || !walls_.contains(stop.at, corner + cut * after)) return stop;
  return {stop.segment, stop.along, corner, stop.at, v, cut};
}

double StopFinder::length(const Stop& stop) const {
  if (!stop.turn) return 2 * distance(stop.from, stop.at);
  const auto [a, b] = ends_of_cut(stop, path_);
  return distance(a, stop.at) + distance(stop.at, b) - 2 * stop.cut;
}

namespace {

/// Only one stop cuts off a turn, and only where no other stop leaves the path.
void keep_apart(const FlatPath& path, std::vector<Stop>& stops) {
  struct Along {
    double first = std::numeric_limits<double>::infinity(), last = 0;
  };
  std::map<std::size_t, int> at_turn;  // by vertex; maps, because a path may have millions of segments
  std::map<std::size_t, Along> along;  // by segment
  for (const Stop& s : stops) {
    if (s.turn) ++at_turn[*s.turn];
    if (s.turn) continue;
    Along& a = along[s.segment];
    a = {std::min(a.first, s.along), std::max(a.last, s.along)};
  }
  for (Stop& s : stops) {
    if (!s.turn) continue;
    const std::size_t before = *s.turn - 1, after = *s.turn;
    if (at_turn[*s.turn] > 1 || along[after].first < s.cut || along[before].last > path.length(before) - s.cut)
      s.turn.reset();
  }
}

Path driven(const FlatPath& path, const std::vector<Stop>& stops) {
  std::map<std::size_t, const Stop*> turns;  // by vertex
  for (const Stop& s : stops)
    if (s.turn) turns[*s.turn] = &s;
  auto turn = turns.begin();
  PathBuilder builder(path.points.front());
  auto next = stops.begin();
  for (std::size_t i = 0; i < path.tool.size(); ++i) {
    for (; next != stops.end() && next->segment == i; ++next) {
      if (next->turn) continue;
      builder.drive(next->from, path.tool[i]);
      builder.drive(Polyline{next->at, next->from}, true);
    }
    if (turn != turns.end() && turn->first == i + 1) {
      const Stop& s = *turn->second;
      const auto [a, b] = ends_of_cut(s, path.points);
      builder.drive(Polyline{a, s.at, b}, true);
      ++turn;
    } else {
      builder.drive(path.points[i + 1], path.tool[i]);
    }
  }
  return builder.take();
}

}  // namespace

Path with_stops(const Path& path, const Point& start, std::vector<Polygon>& pieces, double reach,
                const EdgeIndex& walls) {
  if (pieces.empty() || path.legs.empty()) return path;
  const FlatPath flat(path, start);
  const StopFinder finder(flat.points, flat.tool, reach, walls, pieces);
  std::vector<Stop> stops;
  std::erase_if(pieces, [&](const Polygon& piece) {
    const auto stop = finder.find(piece);
    if (stop) stops.push_back(*stop);
    return stop.has_value();
  });
  if (stops.empty()) return path;
  keep_apart(flat, stops);
  std::ranges::stable_sort(stops, {}, [](const Stop& s) { return std::tuple(s.segment, s.along); });
  return driven(flat, stops);
}

}  // namespace oxturn
