#include "metrics/footprint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/predicates.hpp"
#include "maps/map.hpp"
#include "maps/robot.hpp"

namespace oxturn {
namespace {

using Edge = EdgeIndex::Edge;

/// The convex hull of the body, so many times as large, at a and at b.
Ring swept(const Ring& body, double scale, const Point& a, const Point& b) {
  std::vector<Point> points;
  for (const Point& p : body) {
    points.push_back(a + scale * p);
    points.push_back(b + scale * p);
  }
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Ring hull;  // Andrew's monotone chain, with exact turns
  for (int half = 0; half < 2; ++half) {
    const std::size_t base = hull.size();
    for (const Point& p : points) {
      while (hull.size() >= base + 2 && orientation(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// The segment has a point strictly inside the convex ring: no line parts them, and the only lines that could are those
/// along the ring's sides and along the segment. Exact for the coordinates given.
bool inside(const Ring& hull, const Edge& e) {
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

bool hits(const Ring& body, double scale, const Point& a, const Point& b, const EdgeIndex& walls) {
  const Ring hull = swept(body, scale, a, b);
  bool any = false;
  walls.for_each_near(box_of(hull), [&](std::size_t e) { any = any || inside(hull, walls.edges()[e]); });
  return any;
}

/// The largest t in [0, 1] for which `fine(t)` holds, given fine(0); it holds up to some t.
template <class F>
double last(F fine) {
  double low = 0, high = 1;
  for (int k = 0; k < 50; ++k) {
    const double t = (low + high) / 2;
    (fine(t) ? low : high) = t;
  }
  return low;
}

double depth(const Ring& body, const Point& a, const Point& b, const EdgeIndex& walls) {
  return in_radius(body) * (1 - last([&](double scale) { return !hits(body, scale, a, b, walls); }));
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
      const double t = at_once ? 0 : last([&](double s) { return !hits(footprint, scale, a, lerp(a, b, s), walls); });
      return FootprintHit{lerp(a, b, t), depth(footprint, a, b, walls)};
    }
  return std::nullopt;
}

double footprint_clearance(const Path& path, const Ring& footprint, const EdgeIndex& walls) {
  const double inner = in_radius(footprint);
  double least = std::numeric_limits<double>::infinity();
  bool outside = false;
  const auto look = [&](const Point& a, const Point& b) {
    if (const auto hit = walls.nearest(a, b, least + inner)) least = std::min(least, hit->distance - inner);
    const Ring hull = swept(footprint, 1, a, b);
    Box box = box_of(hull);
    box.grow(std::max(0.0, least));
    bool hit = false;
    walls.for_each_near(box, [&](std::size_t e) {
      const Edge& wall = walls.edges()[e];
      hit = hit || inside(hull, wall);
      for (std::size_t i = 0; !hit && i < hull.size(); ++i)
        least = std::min(least, distance_between(wall, hull[i], hull[(i + 1) % hull.size()]));
    });
    if (hit) least = std::min(least, -depth(footprint, a, b, walls));
  };
  for (const Leg& leg : path.legs)
    for (std::size_t i = 0; i < leg.points.size(); ++i) {
      look(leg.points[i == 0 ? 0 : i - 1], leg.points[i]);
      outside = outside || !walls.contains(leg.points[i]);
    }
  if (outside)
    for (const Leg& leg : path.legs)
      for (const Point& p : leg.points)
        if (!walls.contains(p))
          if (const auto hit = walls.nearest(p)) least = std::min(least, -hit->distance - inner);
  return least;
}

}  // namespace oxturn
