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
  check_site("pillars", p);
  const double gap = narrowest_passage(p);
  // Diagonal neighbours are spacing * sqrt 2 apart; the passage between them is that less two radii. Jitter takes up to
  // half of the excess on either side.
  const double least = (gap + 2 * p.pillar) / std::sqrt(2.0);
  const double spacing = p.spacing > 0 ? p.spacing : std::max(kExcess * least, kRowsApart * p.pillar);
  if (spacing < least)
    refuse("pillars", "spacing is " + number(p.spacing) + " m, expected at least " + number(least) +
                          " m for a robot between pillars of radius " + number(p.pillar) + " m");
  if (p.width / spacing * p.height / spacing / 2 * p.chords > kMostVertices)
    refuse("pillars", "pillars " + number(spacing) + " m apart make more than 2 * 10^7 vertices in " + number(p.width) +
                          " x " + number(p.height) + " m; take a larger spacing or fewer chords");
  const double slack = p.jitter * (spacing - least) / 2;
  Polygon polygon{box_region({0, 0}, {p.width, p.height}).polygons[0].outer, {}};
  const double margin = gap + p.pillar + slack;
  for (int j = 0; margin + j * spacing <= p.height - margin; ++j)
    for (int i = j % 2; margin + i * spacing <= p.width - margin; i += 2) {
      const Point shift(slack * rng.between(-1, 1), slack * rng.between(-1, 1));
      Ring ring = disc(p.chords, p.pillar, Point(margin + i * spacing, margin + j * spacing) + shift);
      polygon.holes.emplace_back(ring.rbegin(), ring.rend());
    }
  return finished({{std::move(polygon)}}, p);
}

}  // namespace

GeneratorInfo pillars() {
  return describe_generator<Params>(
      "pillars", "a hall with pillars in staggered rows",
      "disjoint convex holes at least `passage` robot diameters from each other and from the border: connected",
      with_site<Params>(
          {{"pillar", &Params::pillar, Range{0.001, 10000}, "metres; radius of a pillar"},
           {"spacing", &Params::spacing, Range{0, 10000},
            "metres between rows, and between columns; 0: diagonal passages are open and those along rows are not"},
           {"jitter", &Params::jitter, Range{0, 1}, "how far pillars are off their regular positions"},
           {"chords", &Params::chords, Range{3, 1000}, "corners of a pillar"}}),
      make);
}

}  // namespace oxturn::generator
