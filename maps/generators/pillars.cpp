// A hall full of pillars in staggered rows: passages along the rows are closed, diagonal ones are open. O(pillars).
//
// Source      MyCarbot (TH Nuernberg): an admitted weakness of its rectangles ("sehr viele kleine Hindernisse ...
//             versetzt angeordnet")
#include <algorithm>
#include <cmath>

#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {
  Params() { width = 12, height = 12; }
  double pillar = 0.6;
  double spacing = 0;
  double jitter = 0;
  int chords = 4;
};

constexpr double kExcess = 1.15;     // default spacing over the least
constexpr double kRowsApart = 2.15;  // default spacing in pillar radii, at least: rows do not overlap
constexpr double kMostVertices = 2e7;

Region make(const Params& p, Rng& rng) {
  const double gap = narrowest_passage(p);
  // Diagonal neighbours are spacing * sqrt 2 apart; the passage between them is that less two radii. Jitter takes up to
  // half of the excess on either side.
  const double least = (gap + 2 * p.pillar) / std::sqrt(2.0);
  const double spacing = p.spacing > 0 ? p.spacing : std::max(kExcess * least, kRowsApart * p.pillar);
  if (spacing < least)
    throw_invalid("spacing is {:.4g} m, expected at least {:.4g} m for a robot between pillars of radius {:.4g} m",
                  p.spacing, least, p.pillar);
  if (p.width / spacing * p.height / spacing / 2 * p.chords > kMostVertices)
    throw_invalid(
        "pillars {:.4g} m apart make more than 2 * 10^7 vertices in {:.4g} x {:.4g} m; take a larger spacing or "
        "fewer chords",
        spacing, p.width, p.height);
  const double slack = p.jitter * (spacing - least) / 2;
  Region hall = floor_of(p);
  const double margin = gap + p.pillar + slack;
  for (int j = 0; margin + j * spacing <= p.height - margin; ++j)
    for (int i = j % 2; margin + i * spacing <= p.width - margin; i += 2) {
      const Point shift(slack * rng.between(-1, 1), slack * rng.between(-1, 1));
      Ring ring = disc(p.chords, p.pillar, Point(margin + i * spacing, margin + j * spacing) + shift);
      hall.polygons[0].holes.emplace_back(ring.rbegin(), ring.rend());
    }
  return hall;
}

}  // namespace

GeneratorInfo pillars() {
  return describe_site<Params>(
      "pillars", "a hall with pillars in staggered rows",
      "disjoint convex holes at least `passage` robot diameters from each other and from the border: connected",
      {{"pillar", &Params::pillar, Range{0.001, 10000}, "metres; radius of a pillar"},
       {"spacing", &Params::spacing, Range{0, 10000},
        "metres between rows, and between columns; 0: diagonal passages are open and those along rows are not"},
       {"jitter", &Params::jitter, Range{0, 1}, "how far pillars are off their regular positions"},
       {"chords", &Params::chords, Range{3, 1000}, "corners of a pillar"}},
      make);
}

}  // namespace oxturn::generator
