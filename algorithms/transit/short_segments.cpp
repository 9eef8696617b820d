#include "algorithms/transit/short_segments.hpp"

#include <optional>

namespace oxturn {
namespace {

/// Where the segment ab, extended beyond b, meets dc extended beyond c, if that is nearer than `most` to b and c.
std::optional<Point> corner(const Point& a, const Point& b, const Point& c, const Point& d, double most) {
  const Point u = b - a, v = c - d;
  const double den = cross(u, v);
  if (den == 0) return std::nullopt;
  const double s = cross(d - a, v) / den, t = cross(d - a, u) / den;
  const Point at = a + s * u;
  if (!(s >= 1 && t >= 1) || distance(at, b) >= most || distance(at, c) >= most) return std::nullopt;
  return at;
}

/// One vertex in place of the last two, before the path goes on to p: around the corner of a wall.
bool join(Polyline& kept, const Point& p, double least, const EdgeIndex& walls) {
  if (kept.size() < 3) return false;
  const Point &last = kept.back(), &before = kept[kept.size() - 2], &earlier = kept[kept.size() - 3];
  const auto fits = [&](const Point& at) { return walls.contains(earlier, at) && walls.contains(at, p); };
  std::optional<Point> at = corner(earlier, before, last, p, least);
  if (!at || !fits(*at)) at = last;
  if (!fits(*at)) return false;
  kept.pop_back();
  kept.back() = *at;
  return true;
}

Polyline without_short_segments(const Polyline& points, double least, const EdgeIndex& walls) {
  Polyline kept;
  kept.reserve(points.size());
  for (const Point& p : points) {
    const bool end = &p == &points.back();
    while (kept.size() > 1) {
      const Point &last = kept.back(), &before = kept[kept.size() - 2];
      const bool near = distance(before, last) < least, near_end = end && distance(last, p) < least;
      if (!near && !near_end) break;
      if (walls.contains(before, p))
        kept.pop_back();
      else if (!near || !join(kept, p, least, walls))  // joining does not bring the last vertex away from the end
        break;
    }
    kept.push_back(p);
  }
  return kept;
}

}  // namespace

Path without_short_segments(Path path, const Problem& problem) {
  const double least = shortest_segment(problem.robot());
  for (Leg& leg : path.legs) leg.points = without_short_segments(leg.points, least, problem.walls());
  return path;
}

}  // namespace oxturn
