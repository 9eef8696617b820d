// maps/generators/field.cpp
// A farm field: an irregular outline with rounded corners, and ponds.
//
// Method      A star-shaped polygon about the centre, its corners cut by ever less, stretched to the size;
//             ponds are convex blobs placed by circumscribed circles.
// Guarantee   The outline is wide at its middle (checked size), ponds keep the narrowest passage from each other
//             and the outline, so free space is connected for the robot.
// Complexity  O((corners * 2^rounding) * ponds)
// Decisions   By default 15 ponds with 71 corners in all, the size of the published examples; with another number
//             of ponds as many corners for each.
#include <algorithm>
#include <cmath>

#include "maps/generators/shape.hpp"

namespace oxturn::generator {
namespace {

struct Params : SiteSettings {
  Params() { width = 60, height = 40; }
  int corners = 6;
  double roughness = 0.5;
  int rounding = 3;
  int ponds = 15;
  int pond_corners = 0;
  double pond_area = 0.12;
};

constexpr int kTries = 20000;  // for one pond

Ring outline(const Params& p, Rng& rng) {
  Ring ring;
  for (int i = 0; i < p.corners; ++i) {
    const double turns = (i + 0.6 * p.roughness * (rng.unit() - 0.5)) / p.corners;
    const double radius = 1 - 0.4 * p.roughness * rng.unit();
    ring.push_back(radius * direction(turns + 0.125));
  }
  // Ever smaller cuts, so that the sides stay straight between the rounded corners.
  for (double k = 0, most = 0.18; k < p.rounding; ++k, most *= 0.4) ring = cut_vertices(ring, 0.3, most);
  Box box;
  for (const Point& q : ring) box.add(q);
  for (Point& q : ring)
    q = {(q.x() - box.low.x()) / box.size().x() * p.width, (q.y() - box.low.y()) / box.size().y() * p.height};
  return ring;
}

bool clear_of(const Ring& ring, const Point& centre, double distance) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (distance_to_segment(centre, ring[i], ring[(i + 1) % ring.size()]) < distance) return false;
  return contains({{{ring, {}}}}, centre);
}

Region make(const Params& p, Rng& rng) {
  check_site("field", p, 12);
  const int pond_corners =
      p.pond_corners > 0 ? p.pond_corners : static_cast<int>(std::floor(71.0 * p.ponds / 15 + 0.5));
  if (pond_corners < 3 * p.ponds)
    refuse("field", "pond_corners is " + std::to_string(pond_corners) + ", expected at least 3 for each of " +
                        std::to_string(p.ponds) + " ponds");
  const double gap = narrowest(p);
  Polygon polygon{outline(p, rng), {}};
  if (p.ponds > 0) {
    const double typical = std::sqrt(p.pond_area * signed_area(polygon.outer) / (p.ponds * kPi));
    std::vector<double> radii;
    for (int i = 0; i < p.ponds; ++i) radii.push_back(typical * rng.between(0.6, 1.25));
    std::sort(radii.rbegin(), radii.rend());  // large ones first: they need the room
    std::vector<int> corners;
    for (int i = 0; i < p.ponds; ++i)
      corners.push_back((pond_corners * (i + 1LL)) / p.ponds - (pond_corners * static_cast<long long>(i)) / p.ponds);
    rng.shuffle(corners);
    Spacing spacing(p.width, p.height, radii.front(), gap);
    for (int i = 0; i < p.ponds; ++i) {
      const double radius = radii[static_cast<std::size_t>(i)];
      for (int attempt = 0;; ++attempt) {
        if (attempt == kTries)
          refuse("field", "only " + std::to_string(i) + " of " + std::to_string(p.ponds) +
                              " ponds fit; lower ponds or pond_area, or take a larger size");
        const double x = rng.between(0.0, p.width);
        const double y = rng.between(0.0, p.height);
        if (!spacing.fits({x, y}, radius) || !clear_of(polygon.outer, {x, y}, radius + gap)) continue;
        spacing.add({x, y}, radius);
        polygon.holes.push_back(convex_blob(rng, corners[static_cast<std::size_t>(i)], radius, {x, y}));
        break;
      }
    }
  }
  return finished({{std::move(polygon)}}, p);
}

}  // namespace

GeneratorInfo field() {
  return describe_generator<Params>(
      "field", "a farm field with ponds",
      "disjoint convex holes at least `passage` robot diameters from each other and from the outline: connected",
      with_site<Params>(
          {{"corners", &Params::corners, Range{4, 40}, "of the outline, before rounding"},
           {"roughness", &Params::roughness, Range{0, 1}, "how irregular the outline is"},
           {"rounding", &Params::rounding, Range{0, 5}, "times the outline's corners are cut"},
           {"ponds", &Params::ponds, Range{0, 100000}, "number of holes"},
           {"pond_corners", &Params::pond_corners, Range{0, 1000000},
            "corners of all ponds together; 0: 71 for every 15 ponds"},
           {"pond_area", &Params::pond_area, Range{0.0001, 0.5}, "share of the field within the ponds' round hulls"}}),
      make);
}

}  // namespace oxturn::generator
