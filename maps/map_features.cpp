// Decisions   1. The narrowest passage is found by erosion with growing radii: the first at which a polygon of the
//                free space falls apart. Radii grow by a tenth, from 1/1000 of the polygon's shorter side on; the step
//                at which it falls apart is halved until 2 % are left.
//             2. Parts below a thousandth of the area of the disc do not count: they are what rounding leaves of a
//                passage that closes along its length.
#include "maps/map_features.hpp"

#include <algorithm>

#include "geometry/overlay/offset.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kMostVertices = 5000;
constexpr double kSmallest = 1e-3, kGrowth = 1.1, kAccuracy = 1.02, kNegligible = 1e-3;

std::size_t reflex_vertices(const Ring& ring) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point &a = ring[i], &b = ring[(i + 1) % ring.size()], &c = ring[(i + 2) % ring.size()];
    count += cross(b - a, c - b) < 0;
  }
  return count;
}

enum class State { whole, split, gone };

State eroded_state(const Region& polygon, double radius) {
  const Region eroded = erode(polygon, radius, radius / 100, Bound::outside);
  const auto parts = std::count_if(eroded.polygons.begin(), eroded.polygons.end(),
                                   [&](const Polygon& p) { return area(p) > kNegligible * kPi * radius * radius; });
  return parts > 1 ? State::split : parts == 1 ? State::whole : State::gone;
}

/// The least radius at which the polygon falls apart.
std::optional<double> splitting_radius(const Region& polygon) {
  const double size = bounding_box(polygon).size().minCoeff();
  double whole = 0;
  for (double radius = kSmallest * size; radius < size / 2; radius *= kGrowth) {
    const State state = eroded_state(polygon, radius);
    if (state == State::gone) return std::nullopt;
    if (state == State::whole) {
      whole = radius;
      continue;
    }
    while (whole > 0 && radius > kAccuracy * whole) {
      const double middle = (whole + radius) / 2;
      (eroded_state(polygon, middle) == State::split ? radius : whole) = middle;
    }
    return radius;
  }
  return std::nullopt;
}

std::optional<double> narrowest_passage(const Region& free) {
  if (vertex_count(free) > kMostVertices) return std::nullopt;
  std::optional<double> least;
  for (const Polygon& polygon : free.polygons)
    if (const auto radius = splitting_radius(Region{{polygon}}); radius && (!least || 2 * *radius < *least))
      least = 2 * *radius;
  return least;
}

}  // namespace

MapFeatures map_features(const Map& map) {
  MapFeatures features;
  features.area_m2 = area(map.free);
  features.perimeter_m = perimeter(map.free);
  features.holes = hole_count(map.free);
  for_each_ring(map.free, [&](const Ring& ring) { features.reflex_vertices += reflex_vertices(ring); });
  features.narrowest_m = narrowest_passage(map.free);
  return features;
}

}  // namespace oxturn
