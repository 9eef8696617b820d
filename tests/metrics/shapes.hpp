// Regions and paths that the tests of metrics/ share.
#pragma once

#include <algorithm>

#include "base/random.hpp"
#include "geometry/path.hpp"
#include "geometry/region.hpp"
#include "maps/problem.hpp"

namespace oxturn {

inline Path work(const Polyline& points) { return Path{{Leg{true, points}}}; }

/// A box of 10 x 8 with a square hole and a hexagonal one: boundaries at many angles.
inline Region two_holes() {
  Region r = box_region({0, 0}, {10, 8});
  r.polygons[0].holes.push_back({{2, 2}, {2, 4}, {4, 4}, {4, 2}});
  Ring hexagon;
  for (int k = 6; k-- > 0;) hexagon.push_back(Point(7, 5) + rotated({1.3, 0}, 0.2 + k * kPi / 3));
  r.polygons[0].holes.push_back(hexagon);
  return r;
}

/// Legs of random length and kind, a random walk that stays in the box.
inline Path random_walk(Rng& rng, const Box& box, int legs, int points, double step) {
  Path path;
  Point at(rng.between(box.low.x(), box.high.x()), rng.between(box.low.y(), box.high.y()));
  for (int l = 0; l < legs; ++l) {
    Leg leg{l == 0 || rng.chance(0.75), {at}};
    for (int i = 0; i < points; ++i) {
      Point to = at + Point(rng.between(-step, step), rng.between(-step, step));
      to = to.cwiseMax(box.low).cwiseMin(box.high);
      leg.points.push_back(at = to);
    }
    path.legs.push_back(leg);
  }
  return path;
}

inline Path moved(Path path, double angle, const Point& shift, double scale = 1) {
  for (Leg& leg : path.legs)
    for (Point& p : leg.points) p = rotated(scale * p, angle) + shift;
  return path;
}

inline Polyline arc(const Point& centre, double radius, double from, double to, int chords) {
  Polyline line;
  for (int k = 0; k <= chords; ++k) line.push_back(centre + rotated({radius, 0}, from + (to - from) * k / chords));
  return line;
}

inline void append(Polyline& line, const Polyline& more) { line.insert(line.end(), more.begin(), more.end()); }

inline Problem problem_in(const Region& free, const Point& start, double radius = 0.2, double tool = 0.4) {
  Robot robot;
  robot.radius = radius;
  robot.tool_width = tool;
  return Problem(Map{"drawn", free, "test", "test"}, robot, start);
}

}  // namespace oxturn
