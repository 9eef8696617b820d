// One room with one rectangular obstacle: the simple space of Berg 2021, with a single obstacle for a tether to go
// round. O(1).
//
// Source      after the rectangle room of Berg 2021 (figures 3.5, 4.1 and 4.3, table 4.1). The figures have no scale:
//             sizes and positions are parameters.
#include <algorithm>

#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {
  Params() { width = 12, height = 8; }
  double obstacle_width = 0;
  double obstacle_height = 0;
  double across = 0.5;
  double up = 0.5;
  double jitter = 0;
};

Region make(const Params& p, Rng& rng) {
  const double gap = narrowest_passage(p);
  const auto side = [&](const char* name, double metres, double share, double room) {
    const double most = room - 2 * gap;
    if (metres <= 0) metres = std::min(share * room, most);
    if (metres > most || metres < 0.001)
      throw_invalid(
          "{} is {:.4g} m, expected from 0.001 m to {:.4g} m, so that passages of {:.4g} m stay on both sides", name,
          metres, most, gap);
    return metres;
  };
  const double w = side("obstacle_width", p.obstacle_width, 1.0 / 3, p.width);
  const double h = side("obstacle_height", p.obstacle_height, 1.0 / 4, p.height);
  // Always drawn, so that jitter changes no other draw.
  const double right = rng.between(-0.5, 0.5), higher = rng.between(-0.5, 0.5);
  const auto position = [&](double share, double offset, double room, double size) {
    return gap + (room - size - 2 * gap) * std::clamp(share + p.jitter * offset, 0.0, 1.0);
  };
  const Point low(position(p.across, right, p.width, w), position(p.up, higher, p.height, h));
  Region room = floor_of(p);
  room.polygons[0].holes.push_back(box_region(low, low + Point(w, h)).polygons[0].outer);
  return room;
}

}  // namespace

GeneratorInfo berg_rectangle() {
  return describe_site<Params>(
      "berg-rectangle", "one room with a rectangular obstacle, as in Berg 2021",
      "one rectangle with one rectangular hole, at least `passage` robot diameters from every wall; the seed changes "
      "nothing unless jitter is above 0",
      {{"obstacle_width", &Params::obstacle_width, Range{0, 100000}, "metres; 0: a third of the room's width"},
       {"obstacle_height", &Params::obstacle_height, Range{0, 100000}, "metres; 0: a quarter of the room's height"},
       {"across", &Params::across, Range{0, 1},
        "horizontal position of the obstacle; 0: as far left as a passage allows, 1: right"},
       {"up", &Params::up, Range{0, 1}, "vertical position of the obstacle; 0: as low as a passage allows, 1: as high"},
       {"jitter", &Params::jitter, Range{0, 1}, "how far the seed moves the obstacle from that position"}},
      make, 2);
}

}  // namespace oxturn::generator
