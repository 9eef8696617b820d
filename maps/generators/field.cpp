// A farm field: an irregular outline with rounded corners, and ponds.
//
// Method      A star-shaped polygon about the centre, its corners cut several times, each time by less, scaled to the
//             size; ponds are convex polygons placed by their circumscribed circles.
// Guarantee   The outline is wide in its middle (the size is checked), and ponds keep the narrowest passage from each
//             other and from the outline, so free space is connected for the robot.
// Complexity  O((corners * 2^rounding) * ponds)
// Decisions   By default 15 ponds with 71 vertices in all, the size of the published examples; with another number of
//             ponds as many vertices for each.
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

constexpr int kTries = 20000;  // to find a position for one pond
constexpr double kPublishedVertices = 71, kPublishedPonds = 15;
constexpr double kFirstCut = 0.18,
                 kCutRatio = 0.4;  // most that rounding cuts off an edge: first, then from time to time

Ring outline(const Params& p, Rng& rng) {
  Ring ring;
  for (int i = 0; i < p.corners; ++i) {
    const double turns = (i + 0.6 * p.roughness * (rng.unit() - 0.5)) / p.corners;
    const double radius = 1 - 0.4 * p.roughness * rng.unit();
    ring.push_back(radius * direction(turns + 0.125));
  }
  // Cuts become smaller, so that the sides stay straight between the rounded corners.
  for (double k = 0, most = kFirstCut; k < p.rounding; ++k, most *= kCutRatio) ring = cut_vertices(ring, 0.3, most);
  const Box box = bounding_box(ring);
  for (Point& q : ring)
    q = {(q.x() - box.low.x()) / box.size().x() * p.width, (q.y() - box.low.y()) / box.size().y() * p.height};
  return ring;
}

/// Does the disc lie inside the ring?
bool contains_disc(const Ring& ring, const Point& centre, double radius) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (distance_to_segment(centre, ring[i], ring[(i + 1) % ring.size()]) < radius) return false;
  return contains({{{ring, {}}}}, centre);
}

/// Radii of the ponds, largest first.
std::vector<double> pond_radii(const Params& p, double field_area, Rng& rng) {
  const double typical = std::sqrt(p.pond_area * field_area / (p.ponds * kPi));
  std::vector<double> radii;
  for (int i = 0; i < p.ponds; ++i) radii.push_back(typical * rng.between(0.6, 1.25));
  std::sort(radii.rbegin(), radii.rend());
  return radii;
}

/// Numbers of vertices of the ponds: as equal as possible, in random order.
std::vector<int> pond_vertices(const Params& p, int total, Rng& rng) {
  std::vector<int> vertices;
  for (int i = 0; i < p.ponds; ++i)
    vertices.push_back((total * (i + 1LL)) / p.ponds - (total * static_cast<long long>(i)) / p.ponds);
  rng.shuffle(vertices);
  return vertices;
}

void add_ponds(Polygon& field, const Params& p, int vertices, Rng& rng) {
  const double gap = narrowest_passage(p);
  const std::vector<double> radii = pond_radii(p, signed_area(field.outer), rng);
  const std::vector<int> vertices_of = pond_vertices(p, vertices, rng);
  Spacing spacing(p.width, p.height, radii.front(), gap);
  int tries = 0;
  for (std::size_t i = 0; i < radii.size();) {
    if (tries++ == kTries)
      throw_invalid("only {} of {} ponds fit; lower ponds or pond_area, or take a larger size", i, p.ponds);
    const double x = rng.between(0.0, p.width);
    const double y = rng.between(0.0, p.height);
    if (!spacing.fits({x, y}, radii[i]) || !contains_disc(field.outer, {x, y}, radii[i] + gap)) continue;
    spacing.add({x, y}, radii[i]);
    field.holes.push_back(convex_blob(rng, vertices_of[i], radii[i], {x, y}));
    ++i;
    tries = 0;
  }
}

Region make(const Params& p, Rng& rng) {
  const int vertices = p.pond_corners > 0
                           ? p.pond_corners
                           : static_cast<int>(std::floor(kPublishedVertices * p.ponds / kPublishedPonds + 0.5));
  if (vertices < 3 * p.ponds)
    throw_invalid("pond_corners is {}, expected at least 3 for each of {} ponds", vertices, p.ponds);
  Polygon polygon{outline(p, rng), {}};
  if (p.ponds > 0) add_ponds(polygon, p, vertices, rng);
  return {{std::move(polygon)}};
}

}  // namespace

GeneratorInfo field() {
  return describe_site<Params>(
      "field", "a farm field with ponds",
      "disjoint convex holes at least `passage` robot diameters from each other and from the outline: connected",
      {{"corners", &Params::corners, Range{4, 40}, "of the outline, before rounding"},
       {"roughness", &Params::roughness, Range{0, 1}, "how irregular the outline is"},
       {"rounding", &Params::rounding, Range{0, 5}, "how often the outline's corners are cut"},
       {"ponds", &Params::ponds, Range{0, 100000}, "number of holes"},
       {"pond_corners", &Params::pond_corners, Range{0, 1000000},
        "vertices of all ponds together; 0: 71 for every 15 ponds"},
       {"pond_area", &Params::pond_area, Range{0.0001, 0.5},
        "share of the field within the ponds' circumscribed circles"}},
      make, 12);
}

}  // namespace oxturn::generator
