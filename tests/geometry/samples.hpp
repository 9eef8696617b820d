// Shapes and oracles that the geometry tests share. They use no oxturn algorithm beyond Rng.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "geometry/raster.hpp"
#include "geometry/region.hpp"

namespace oxturn::samples {

/// A star-shaped ring about `centre`, counter-clockwise.
inline Ring star(Rng& rng, const Point& centre, double low, double high, int corners) {
  Ring ring;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * kPi * (k + 0.8 * rng.unit()) / corners;
    ring.push_back(centre + rng.between(low, high) * Point(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

inline Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

/// A star with a few star holes well inside.
inline Region holed_star(Rng& rng, const Point& centre, double size) {
  Polygon p{star(rng, centre, 0.8 * size, size, rng.between(14, 40)), {}};
  for (int k = 0; k < 4; ++k) {
    const Point at = centre + 0.4 * size * Point(std::cos(k * kPi / 2), std::sin(k * kPi / 2));
    p.holes.push_back(reversed(star(rng, at, 0.02 * size, 0.2 * size, rng.between(5, 12))));
  }
  return {{p}};
}

/// Overlapping random boxes on a lattice: what a traced laser map looks like. 1 = free.
inline BitGrid speckled(Rng& rng, int n, double cell, int boxes, int largest) {
  BitGrid grid({-1, 2}, cell, n, n);
  std::fill(grid.bits.begin(), grid.bits.end(), std::uint8_t{1});
  for (int k = 0; k < boxes; ++k) {
    const int w = rng.between(1, largest), h = rng.between(1, largest), i0 = rng.between(0, n - 1),
              j0 = rng.between(0, n - 1);
    for (int j = j0; j < std::min(n, j0 + h); ++j)
      for (int i = i0; i < std::min(n, i0 + w); ++i) grid.set(i, j, false);
  }
  return grid;
}

/// Distance to the nearest edge, by trying them all.
inline double distance_to_boundary(const Region& region, const Point& p) {
  double best = 1e300;
  for_each_ring(region, [&](const Ring& r) {
    for (std::size_t i = 0, j = r.size() - 1; i < r.size(); j = i++)
      best = std::min(best, distance_to_segment(p, r[j], r[i]));
  });
  return best;
}

/// Is p inside, by the sum of the angles under which it sees the edges? (Not near the boundary.)
inline bool sees_all_round(const Region& region, const Point& p) {
  double sum = 0;
  for_each_ring(region, [&](const Ring& r) {
    for (std::size_t i = 0, j = r.size() - 1; i < r.size(); j = i++)
      sum += std::atan2(cross(r[j] - p, r[i] - p), (r[j] - p).dot(r[i] - p));
  });
  return std::abs(sum) > kPi;
}

/// Corners and points along the edges.
inline std::vector<Point> boundary_points(const Region& region, int per_edge) {
  std::vector<Point> out;
  for_each_ring(region, [&](const Ring& r) {
    for (std::size_t i = 0, j = r.size() - 1; i < r.size(); j = i++)
      for (int k = 0; k < per_edge; ++k) out.push_back(lerp(r[j], r[i], (k + 0.0) / per_edge));
  });
  return out;
}

}  // namespace oxturn::samples
