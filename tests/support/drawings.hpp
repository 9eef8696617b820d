// Drawings generated from a seed, on a canvas: polylines, closed strokes inside one another, shapes like letters,
// filled areas with holes.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "base/random.hpp"
#include "geometry/overlay/boolean.hpp"
#include "maps/problem.hpp"

namespace oxturn {

struct DrawingKind {
  int polylines = 6, closed = 3, nested = 2, letters = 4, areas = 2;
  double width = 20, height = 15, margin = 1;
};

class DrawingGenerator {
 public:
  DrawingGenerator(std::uint64_t seed, DrawingKind kind) : rng_(mix(seed, "drawing")), kind_(kind) {}

  Drawing drawing() {
    for (int k = 0; k < kind_.polylines; ++k) stroke(fmt::format("line{}", k), wiggle(point(), rng_.between(2, 8)));
    for (int k = 0; k < kind_.closed; ++k) {
      const Point centre = point();
      double radius = rng_.between(0.5, 2.5);
      for (int n = 0; n < kind_.nested; ++n, radius *= 0.55)
        stroke(fmt::format("ring{}.{}", k, n), blob(centre, radius, true));
    }
    for (int k = 0; k < kind_.letters; ++k) letter(k, point());
    Region drawn;  // areas are disjoint
    for (int k = 0; k < kind_.areas; ++k) {
      const Point centre = point();
      const double radius = rng_.between(0.8, 2.5);
      Region area{{{clipped(blob(centre, radius, false)), {}}}};
      if (rng_.chance(0.5)) area = subtract(area, Region{{{clipped(blob(centre, 0.4 * radius, false)), {}}}});
      area = subtract(area, drawn);
      drawn = unite({drawn, area});
      for (const Polygon& part : area.polygons) add_area(k, part);
    }
    return std::move(drawing_);
  }

 private:
  static constexpr double kWidths[] = {0.04, 0.16, 0.32, 0.42};

  void stroke(const std::string& element, Polyline points) {
    if (points.size() < 2) return;
    DrawnStroke stroke{};
    stroke.element = element;
    stroke.points = std::move(points);
    stroke.width = kWidths[rng_.below(4)];
    for (std::size_t k = 0; k < stroke.points.size(); ++k) stroke.nodes.push_back(k);
    for (std::size_t k = 1; k + 1 < stroke.points.size(); ++k) stroke.corners.push_back(k);
    if (stroke.points.front() == stroke.points.back()) stroke.corners.push_back(stroke.points.size() - 1);
    drawing_.strokes.push_back(std::move(stroke));
  }
  void add_area(int k, const Polygon& part) {
    static const std::vector<std::string> kFills{"", "spiral", "zigzag", "contour"};
    FilledArea area{.element = fmt::format("area{}", k), .area = part, .choice = {}};
    area.choice.fill = kFills[rng_.below(4)];
    if (rng_.chance(0.3)) area.choice.angle = rng_.between(-3.0, 3.0);
    drawing_.areas.push_back(std::move(area));
  }
  /// A vertical stem and some bars, as a letter of a font of single strokes.
  void letter(int k, const Point& at) {
    const double size = rng_.between(0.6, 1.5);
    stroke(fmt::format("letter{}.0", k), {inside(at), inside(at + Point(0, size))});
    for (int bar = 1; bar <= rng_.between(1, 3); ++bar) {
      const double y = size * rng_.between(0, 2) / 2;
      stroke(fmt::format("letter{}.{}", k, bar),
             {inside(at + Point(0, y)), inside(at + Point(0.6 * size, y + rng_.between(-0.3, 0.3)))});
    }
  }
  Point point() {
    return {rng_.between(kind_.margin, kind_.width - kind_.margin),
            rng_.between(kind_.margin, kind_.height - kind_.margin)};
  }
  Point inside(const Point& p) const {
    return {std::clamp(p.x(), kind_.margin, kind_.width - kind_.margin),
            std::clamp(p.y(), kind_.margin, kind_.height - kind_.margin)};
  }
  Ring clipped(Polyline line) const {
    for (Point& p : line) p = inside(p);
    return line;
  }
  Polyline wiggle(Point at, double metres) {
    Polyline line{at};
    double heading = rng_.between(-kPi, kPi);
    for (double d = 0; d < metres; d += 0.4) {
      heading += rng_.between(-0.6, 0.6);
      at = inside(at + 0.4 * Point(std::cos(heading), std::sin(heading)));
      if (at != line.back()) line.push_back(at);
    }
    return line;
  }
  Polyline blob(const Point& centre, double radius, bool close) {
    Polyline ring;
    const int n = rng_.between(3, 24);
    const double turn = rng_.between(-kPi, kPi);
    for (int k = 0; k < n; ++k) {
      const double angle = turn + 2 * kPi * k / n, r = radius * rng_.between(0.8, 1.0);
      const Point p = inside(centre + r * Point(std::cos(angle), std::sin(angle)));
      if (ring.empty() || p != ring.back()) ring.push_back(p);
    }
    if (close && ring.back() != ring.front()) ring.push_back(ring.front());
    return ring;
  }

  Rng rng_;
  DrawingKind kind_;
  Drawing drawing_;
};

inline Problem canvas(Drawing drawing, Robot robot, const DrawingKind& kind = {}) {
  Map map{"canvas", box_region({0, 0}, {kind.width, kind.height}), "", ""};
  map.drawing = std::make_shared<const Drawing>(std::move(drawing));
  return Problem(std::move(map), std::move(robot), Point(0.5, 0.5));
}

/// The robot of Vollprecht 2014: a rake of seven pins, 0.42 m.
inline Robot beach_robot(double min_turn_radius = 0) {
  Robot robot;
  robot.radius = 0.3;
  robot.tool_width = 0.42;
  robot.min_turn_radius = min_turn_radius;
  return robot;
}

}  // namespace oxturn
