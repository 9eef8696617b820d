#include "metrics/footprint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/convex_hull.hpp"
#include "geometry/predicates.hpp"
#include "maps/map.hpp"
#include "maps/robot.hpp"

namespace oxturn {
namespace {

using Edge = EdgeIndex::Edge;

/// What the body covers while it moves from a to b, scaled by `scale` about its centre.
Ring swept_hull(const Ring& body, double scale, const Point& a, const Point& b) {
  std::vector<Point> points;
  for (const Point& p : body) {
    points.push_back(a + scale * p);
    points.push_back(b + scale * p);
  }
  return convex_hull(std::move(points));
}

/// Does the segment meet the interior of the convex ring? It does unless a line separates the two, and only the lines
/// along the ring's sides and along the segment could. Exact.
bool meets_interior(const Ring& hull, const Edge& e) {
  bool left = false, right = false;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Point &p = hull[i], &q = hull[(i + 1) % hull.size()];
    if (orientation(p, q, e.a) <= 0 && orientation(p, q, e.b) <= 0) return false;
    const int side = orientation(e.a, e.b, p);
    left = left || side > 0;
    right = right || side < 0;
  }
  return left && right;
}

Box box_of(const Ring& ring) {
  Box box;
  for (const Point& p : ring) box.add(p);
  return box;
}

/// Does a wall meet the interior of the scaled body while it moves from a to b?
bool hits(const Ring& body, double scale, const Point& a, const Point& b, const EdgeIndex& walls) {
  const Ring hull = swept_hull(body, scale, a, b);
  bool any = false;
  walls.for_each_near(box_of(hull), [&](std::size_t e) { any = any || meets_interior(hull, walls.edges()[e]); });
  return any;
}

/// The largest t in [0, 1] with free(t), by bisection; free(0) must be true and free() monotone.
template <class F>
double last_free(F free) {
  constexpr int kBisections = 50;
  double low = 0, high = 1;
  for (int k = 0; k < kBisections; ++k) {
    const double t = (low + high) / 2;
    (free(t) ? low : high) = t;
  }
  return low;
}

/// Metres by which the body's sides would have to be nearer to its centre to move from a to b.
double depth(const Ring& body, const Point& a, const Point& b, const EdgeIndex& walls) {
  return in_radius(body) * (1 - last_free([&](double scale) { return !hits(body, scale, a, b, walls); }));
}

double distance_between(const Edge& e, const Point& p, const Point& q) {
  return std::min({distance_to_segment(e.a, p, q), distance_to_segment(e.b, p, q), distance_to_segment(p, e.a, e.b),
                   distance_to_segment(q, e.a, e.b)});
}

}  // namespace

std::optional<FootprintHit> first_hit(const Path& path, const Ring& footprint, double tolerance,
                                      const EdgeIndex& walls) {
  const double scale = 1 - tolerance / in_radius(footprint);
  for (const Leg& leg : path.legs)
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      const Point &a = leg.points[i - 1], &b = leg.points[i];
      if (!hits(footprint, scale, a, b, walls)) continue;
      const bool at_once = hits(footprint, scale, a, a, walls);
      const double t =
          at_once ? 0 : last_free([&](double s) { return !hits(footprint, scale, a, lerp(a, b, s), walls); });
      return FootprintHit{lerp(a, b, t), depth(footprint, a, b, walls)};
    }
  return std::nullopt;
}

namespace {

/// The least of `least` and the clearance on the segment ab.
double segment_clearance(const Ring& footprint, double inner, const Point& a, const Point& b, const EdgeIndex& walls,
                         double least) {
  if (const auto hit = walls.nearest(a, b, least + inner)) least = std::min(least, hit->distance - inner);
  const Ring hull = swept_hull(footprint, 1, a, b);
  Box box = box_of(hull);
  box.grow(std::max(0.0, least));
  bool hit = false;
  walls.for_each_near(box, [&](std::size_t e) {
    const Edge& wall = walls.edges()[e];
    hit = hit || meets_interior(hull, wall);
    for (std::size_t i = 0; !hit && i < hull.size(); ++i)
      least = std::min(least, distance_between(wall, hull[i], hull[(i + 1) % hull.size()]));
  });
  return hit ? std::min(least, -depth(footprint, a, b, walls)) : least;
}

}  // namespace

double footprint_clearance(const Path& path, const Ring& footprint, const EdgeIndex& walls) {
  const double inner = in_radius(footprint);
  double least = std::numeric_limits<double>::infinity();
  for (const Leg& leg : path.legs)
    for (std::size_t i = 0; i < leg.points.size(); ++i)
      least = segment_clearance(footprint, inner, leg.points[i == 0 ? 0 : i - 1], leg.points[i], walls, least);
  for (const Leg& leg : path.legs)
    for (const Point& p : leg.points)
      if (!walls.contains(p))
        if (const auto hit = walls.nearest(p)) least = std::min(least, -hit->distance - inner);
  return least;
}

}  // namespace oxturn
