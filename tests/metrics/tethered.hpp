// Tethered problems and paths that the tests of the tether's metrics share.
#pragma once

#include "base/random.hpp"
#include "geometry/edge_index.hpp"
#include "maps/problem.hpp"
#include "shapes.hpp"

namespace oxturn {

/// A room of 12 x 10 about a square pillar from (4, 4) to (6, 6).
inline Region pillar_room() {
  Region r = box_region({-1, 0}, {11, 10});
  r.polygons[0].holes.push_back({{4, 4}, {4, 6}, {6, 6}, {6, 4}});
  return r;
}

inline Problem leashed(const Region& free, const Point& start, std::optional<Point> anchor = {}, double length = 1000,
                       double radius = 0.2) {
  Robot robot;
  robot.radius = radius;
  robot.tether = Tether{length};
  return Problem(Map{"drawn", free, "test", "test"}, robot, start, anchor);
}

/// Square and thin pillars, turned, in a room of 12 x 10; corners are dyadic.
inline Region pillars(Rng& rng, int count) {
  Region r = box_region({0, 0}, {12, 10});
  std::vector<Point> middles;
  while (static_cast<int>(middles.size()) < count) {
    const Point middle(rng.between(1.5, 10.5), rng.between(1.5, 8.5));
    if (std::any_of(middles.begin(), middles.end(), [&](const Point& m) { return distance(m, middle) < 2; })) continue;
    middles.push_back(middle);
    const double turn = rng.between(0.0, kPi), w = rng.between(0.2, 0.6), h = rng.between(0.1, 0.6);
    Ring ring;
    for (const Point& corner : {Point(-w, -h), Point(-w, h), Point(w, h), Point(w, -h)}) {
      const Point p = middle + rotated(corner, turn);
      ring.push_back(Point(std::round(p.x() * 1024), std::round(p.y() * 1024)) / 1024);
    }
    r.polygons[0].holes.push_back(ring);
  }
  return r;
}

/// A walk of so many segments in the problem's configuration space, from its start. Vertices are dyadic.
inline Polyline free_walk(const Problem& problem, Rng& rng, int segments, double step) {
  Polyline path{problem.start()};
  while (static_cast<int>(path.size()) <= segments) {
    Point to = path.back() + Point(rng.between(-step, step), rng.between(-step, step));
    to = Point(std::round(to.x() * 1024), std::round(to.y() * 1024)) / 1024;
    if (to != path.back() && problem.walls().contains(path.back(), to)) path.push_back(to);
  }
  return path;
}

}  // namespace oxturn
