// maps/generators/hyun.cpp
// A room with five obstacles, polygons and circles: the kind of world that Hyun's sweeping robot was tried in. O(1).
//
// Source      after W. K. Hyun, "A heuristic sweeping algorithm for autonomous smearing robot": 50 m x 50 m, five
//             obstacles, polygons and circles
// Decisions   1. The figure is not at hand: which obstacles and where is ours. Two circles, a triangle, a pentagon and one
//                that is not convex, spread so that no sweep line meets more than three.
//             2. Circles are regular polygons of `disc_chords` corners.
#include <algorithm>

#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {
  Params() { width = height = 50, robot = 0.5; }
  double jitter = 0;
  int disc_chords = 64;
};

constexpr double kLeastGap = 0.07;  // of the shorter side, between obstacles' boxes and to the walls
constexpr double kMostMove = 0.02;

Region make(const Params& p, Rng& rng) {
  check_site("hyun", p);
  const double side = std::min(p.width, p.height);
  const double gap = (kLeastGap - 2 * kMostMove * p.jitter) * side;
  if (narrowest(p) > gap)
    refuse("hyun", "passages are as narrow as " + number(gap) + " m, expected at least " + number(narrowest(p)) +
                       " m; raise width and height or lower jitter");
  const std::vector<Ring> polygons{{{.46, .56}, {.78, .56}, {.78, .66}, {.58, .66}, {.58, .84}, {.46, .84}},
                                   {{.12, .22}, {.26, .14}, {.38, .24}, {.34, .40}, {.16, .38}},
                                   {{.52, .16}, {.74, .20}, {.60, .40}}};
  struct Circle {
    Point centre;
    double radius;
  };
  const std::vector<Circle> circles{{{.24, .72}, .11}, {{.87, .36}, .06}};

  const auto moved = [&] {  // drawn always, so that jitter does not change anything else's luck
    const double x = rng.between(-1, 1), y = rng.between(-1, 1);
    return Point(p.jitter * kMostMove * side * Point(x, y));
  };
  Polygon room{box_region({0, 0}, {p.width, p.height}).polygons[0].outer, {}};
  for (Ring ring : polygons) {
    const Point by = moved();
    for (Point& corner : ring) corner = Point(p.width * corner.x(), p.height * corner.y()) + by;
    room.holes.push_back(std::move(ring));
  }
  for (const Circle& c : circles)
    room.holes.push_back(
        disc(p.disc_chords, c.radius * side, Point(p.width * c.centre.x(), p.height * c.centre.y()) + moved()));
  return finished({{std::move(room)}}, p);
}

}  // namespace

GeneratorInfo hyun() {
  return describe_generator<Params>(
      "hyun", "a room of 50 m x 50 m with five obstacles, polygons and circles, as for Hyun's sweeping robot",
      "five holes, at least `passage` robot diameters from each other and the walls; the seed changes nothing unless "
      "jitter is above 0",
      with_site<Params>({{"jitter", &Params::jitter, Range{0, 1}, "how far the seed moves the obstacles"},
                         {"disc_chords", &Params::disc_chords, Range{8, 1000}, "chords of a circle"}}),
      make);
}

}  // namespace oxturn::generator
