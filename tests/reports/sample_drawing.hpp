// A drawing and a path made by hand, so that the viewer is tested without a planner: letters, areas (one with a hole,
// one concave), crossing strokes, a closed stroke, transits that are straight and curved.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "geometry/path.hpp"
#include "geometry/trace.hpp"
#include "maps/drawing.hpp"
#include "maps/problem.hpp"

namespace oxturn::sample {

inline constexpr double kPen = 0.16, kRake = 0.56;

inline Polyline arc(const Point& centre, double radius, double from, double to, int steps) {
  Polyline points;
  for (int i = 0; i <= steps; ++i) {
    const double angle = from + (to - from) * i / steps;
    points.push_back(centre + radius * Point(std::cos(angle), std::sin(angle)));
  }
  return points;
}
inline Polyline circle(const Point& centre, double radius, int steps = 64) {
  Polyline points = arc(centre, radius, 0, 2 * kPi, steps);
  points.back() = points.front();
  return points;
}

inline DrawnStroke stroke(std::string element, Polyline points, double width = kPen) {
  DrawnStroke made;
  made.element = std::move(element);
  made.points = std::move(points);
  made.width = width;
  for (std::size_t i = 0; i < made.points.size(); ++i)
    if (made.points.size() < 20 || i % 16 == 0 || i + 1 == made.points.size()) made.nodes.push_back(i);
  return made;
}

inline Polyline wave() {
  Polyline points;
  for (int i = 0; i <= 120; ++i) points.emplace_back(1.5 + 17.0 * i / 120, 1.8 + 0.5 * std::sin(i / 8.0));
  return points;
}

inline Ring crown() { return {{12, 8}, {18, 8}, {18.5, 12.5}, {16.5, 10.5}, {15, 13}, {13.5, 10.5}, {11.5, 12.5}}; }
inline Polygon letter_o() {
  Polyline outer = circle({8.5, 10.2}, 2.2), hole = circle({8.5, 10.2}, 1.0);
  outer.pop_back();
  hole.pop_back();
  std::reverse(hole.begin(), hole.end());
  return {outer, {hole}};
}

inline Drawing drawing() {
  Drawing made;
  made.sha256 = "5a3e";
  made.areas = {{"letter-o", letter_o(), {}}, {"crown", {crown(), {}}, {}}};
  made.strokes = {stroke("letter-a", {{1.5, 8}, {3, 12.4}, {4.5, 8}}),
                  stroke("bar-of-a", {{2.1, 9.7}, {3.9, 9.7}}),
                  stroke("wave", wave()),
                  stroke("cross-1", {{2, 3.5}, {5.5, 6.8}}, kRake),
                  stroke("cross-2", {{2, 6.8}, {5.5, 3.5}}, kRake),
                  stroke("sun <&>", circle({10.5, 5.2}, 1.6))};
  return made;
}

/// The path: an element by `work`, a transit by `go`.
class HandPath {
 public:
  explicit HandPath(const Point& start) : builder_(start) {}
  void work(const Polyline& points, double width) {
    go(points.front());
    builder_.drive(points, true, Gear::forward, width);
  }
  /// In an arc to the left of the straight line.
  void go(const Point& to, double bend = 0.25) {
    const Point from = builder_.at(), pulled = lerp(from, to, 0.5) + bend * perpendicular(to - from);
    Polyline points;
    for (int i = 0; i <= 24; ++i)
      points.push_back(lerp(lerp(from, pulled, i / 24.0), lerp(pulled, to, i / 24.0), i / 24.0));
    points.back() = to;
    builder_.drive(points, false);
  }
  Path take() { return builder_.take(); }

 private:
  PathBuilder builder_;
};

/// Horizontal lanes of the crown.
inline Polyline crown_lanes() {
  Polyline lanes;
  const Ring ring = crown();
  for (int i = 0; i < 8; ++i) {
    const double y = 8.3 + kRake * i;
    std::vector<double> xs;
    for_each_edge(ring, [&](const Point& a, const Point& b) {
      if ((a.y() > y) != (b.y() > y)) xs.push_back(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
    });
    std::sort(xs.begin(), xs.end());
    const Point left(xs.front() + 0.3, y), right(xs.back() - 0.3, y);
    if (xs.size() > 2) break;  // the points of the crown are left to planners
    lanes.push_back(i % 2 == 0 ? left : right);
    lanes.push_back(i % 2 == 0 ? right : left);
  }
  return lanes;
}

inline Path path(const Point& start) {
  HandPath made(start);
  const Drawing shapes = drawing();
  made.work(shapes.strokes[2].points, kPen);
  made.work(shapes.strokes[5].points, kPen);
  made.work(shapes.strokes[3].points, kRake);
  made.work(shapes.strokes[4].points, kRake);
  made.work(shapes.strokes[0].points, kPen);
  made.work(shapes.strokes[1].points, kPen);
  for (const double radius : {1.3, 1.75}) made.work(circle({8.5, 10.2}, radius), kRake);
  made.work(crown_lanes(), kRake);
  return made.take();
}

inline Problem problem() {
  Map map{"sample", box_region({0, 0}, {20, 15}), "file", "sample.svg"};
  map.drawing = std::make_shared<const Drawing>(drawing());
  Robot robot;
  robot.radius = 0.3;
  robot.tool_width = kRake;
  return Problem(std::move(map), robot, Point(1, 0.6));
}

inline std::vector<Trace> traces() {
  return {{"scaled drawing", {{{1, 1}, {19, 1}, {19, 14}, {1, 14}, {1, 1}}}}, {"lanes", {crown_lanes()}}};
}

}  // namespace oxturn::sample
