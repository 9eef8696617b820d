// A room with five obstacles, polygons and circles, like the test map of Hyun (heuristic sweeping). O(1).
//
// Source      after W. K. Hyun, "A heuristic sweeping algorithm for autonomous smearing robot": 50 m x 50 m, five
//             obstacles, polygons and circles
// Decisions   1. The source's figure cannot be read off: shapes and positions are ours. Two circles, a triangle, a
//                pentagon and a non-convex polygon, spread so that no horizontal line meets more than three.
//             2. Circles are regular polygons with `disc_chords` vertices.
#include <algorithm>

#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {
  Params() { width = height = 50, robot = 0.5; }
  double jitter = 0;
  int disc_chords = 64;
};

constexpr double kLeastGap = 0.07;  // of the shorter side: between obstacles' boxes, and to the walls
constexpr double kMostMove = 0.02;  // of the shorter side: by jitter

Region make(const Params& p, Rng& rng) {
  const double side = std::min(p.width, p.height);
  const double gap = (kLeastGap - 2 * kMostMove * p.jitter) * side;
  if (narrowest_passage(p) > gap)
    throw_invalid(
        "passages are as narrow as {:.4g} m, expected at least {:.4g} m; raise width and height or lower jitter", gap,
        narrowest_passage(p));
  const std::vector<Ring> polygons{{{.46, .56}, {.78, .56}, {.78, .66}, {.58, .66}, {.58, .84}, {.46, .84}},
                                   {{.12, .22}, {.26, .14}, {.38, .24}, {.34, .40}, {.16, .38}},
                                   {{.52, .16}, {.74, .20}, {.60, .40}}};
  struct Circle {
    Point centre;
    double radius;
  };
  const std::vector<Circle> circles{{{.24, .72}, .11}, {{.87, .36}, .06}};

  const auto offset = [&] {  // always drawn, so that jitter changes no other draw
    const double x = rng.between(-1, 1), y = rng.between(-1, 1);
    return Point(p.jitter * kMostMove * side * Point(x, y));
  };
  Region room = floor_of(p);
  std::vector<Ring>& holes = room.polygons[0].holes;
  for (Ring ring : polygons) {
    const Point by = offset();
    for (Point& q : ring) q = Point(p.width * q.x(), p.height * q.y()) + by;
    holes.push_back(std::move(ring));
  }
  for (const Circle& c : circles)
    holes.push_back(
        disc(p.disc_chords, c.radius * side, Point(p.width * c.centre.x(), p.height * c.centre.y()) + offset()));
  return room;
}

}  // namespace

GeneratorInfo hyun() {
  return describe_site<Params>(
      "hyun", "a room of 50 m x 50 m with five obstacles, polygons and circles, like the test map of Hyun",
      "five holes, at least `passage` robot diameters from each other and the walls; the seed changes nothing unless "
      "jitter is above 0",
      {{"jitter", &Params::jitter, Range{0, 1}, "how far the seed moves the obstacles"},
       {"disc_chords", &Params::disc_chords, Range{8, 1000}, "chords of a circle"}},
      make);
}

}  // namespace oxturn::generator
