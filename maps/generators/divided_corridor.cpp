// A tall narrow room divided lengthwise by a wall that is open at the top, with small obstacles alternating between the
// left and the right side. O(obstacles).
//
// Source      MyCarbot (TH Nuernberg): an admitted weakness of its rectangles ("zweigeteilte Raeume"). The first
//             rectangle from the bottom lies alternately on the left and on the right, so the robot goes back and forth
//             between them.
#include <algorithm>

#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {
  Params() { width = 5, height = 20; }
  double wall = 0.3;
  double opening = 0;
  int obstacles = 6;
  double jitter = 0.3;
};

Region make(const Params& p, Rng& rng) {
  const double opening = passage_width("opening", p.opening, 3, p);
  const double side = (p.width - p.wall) / 2, gap = narrowest_passage(p);
  const double room = p.height - opening;
  const double pitch = p.obstacles > 0 ? room / p.obstacles : room;
  // Each obstacle leaves the narrowest passage on both of its sides, and between itself and the next.
  const double size = std::min(side - 2 * gap, pitch / 2 - gap);
  if (size <= 0)
    throw_invalid(
        "{} obstacles on each side, {:.4g} x {:.4g} m, leave no passages of {:.4g} m; take fewer obstacles or a "
        "larger width or height",
        p.obstacles, std::max(0.0, side), std::max(0.0, room), gap);
  Polygon polygon;
  polygon.outer = {{0, 0},       {side, 0},           {side, room}, {side + p.wall, room}, {side + p.wall, 0},
                   {p.width, 0}, {p.width, p.height}, {0, p.height}};
  for (int k = 0; k < 2 * p.obstacles; ++k) {  // alternating sides, half a pitch apart
    const bool on_left = k % 2 == 0;
    const double half = size / 2 * (1 - 0.5 * p.jitter * rng.unit());
    const double spare = (pitch - 2 * size - gap) / 4;
    const Point centre(
        (on_left ? 0 : side + p.wall) + side / 2,
        gap + size / 2 + (k * 0.5) * pitch * (room - size - gap) / room + p.jitter * std::max(0.0, spare) * rng.unit());
    const Ring box = box_region(centre - Point(half, half), centre + Point(half, half)).polygons[0].outer;
    polygon.holes.emplace_back(box.rbegin(), box.rend());
  }
  return {{std::move(polygon)}};
}

}  // namespace

GeneratorInfo divided_corridor() {
  return describe_site<Params>(
      "divided-corridor", "a corridor divided lengthwise, with obstacles on alternating sides",
      "disjoint square holes at least `passage` robot diameters from the walls: connected",
      {{"wall", &Params::wall, Range{0.001, 10000}, "metres; thickness of the dividing wall"},
       {"opening", &Params::opening, Range{0, 10000},
        "metres; at the upper end of the dividing wall; 0: 3 robot diameters"},
       {"obstacles", &Params::obstacles, Range{0, 100000}, "on each side"},
       {"jitter", &Params::jitter, Range{0, 1}, "how much obstacles differ in size and spacing"}},
      make);
}

}  // namespace oxturn::generator
