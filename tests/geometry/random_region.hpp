// Regions for tests, built by hand without Clipper, and a visibility-graph oracle for shortest paths.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/random.hpp"
#include "geometry/region.hpp"

namespace oxturn {

/// A convex polygon inscribed in a circle: `corners` sorted angles, counter-clockwise.
inline Ring convex_ring(Rng& rng, const Point& centre, double radius, int corners) {
  Ring ring;
  const double turn = rng.between(0.0, 2 * kPi);
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + 2 * kPi * (i + 0.6 * rng.unit()) / corners;
    ring.push_back(centre + radius * Point(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

/// The box [0, columns] x [0, rows] less one convex hole in most unit cells. With `on_grid`, holes are axis-parallel
/// rectangles with corners on a lattice: collinear corners, equal coordinates and ties everywhere.
inline Region clutter_box(Rng& rng, int columns, int rows, bool on_grid, double fill = 0.85) {
  Polygon p;
  p.outer = {{0, 0}, {1.0 * columns, 0}, {1.0 * columns, 1.0 * rows}, {0, 1.0 * rows}};
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      if (!rng.chance(fill)) continue;
      Ring hole;
      if (on_grid) {
        const double x0 = i + 0.125 * rng.between(1, 3), x1 = i + 0.125 * rng.between(5, 7);
        const double y0 = j + 0.125 * rng.between(1, 3), y1 = j + 0.125 * rng.between(5, 7);
        hole = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
      } else {
        hole = convex_ring(rng, Point(i + 0.5, j + 0.5), rng.between(0.2, 0.45), rng.between(3, 8));
      }
      std::reverse(hole.begin(), hole.end());
      p.holes.push_back(hole);
    }
  }
  return {{p}};
}

/// A star-shaped, strongly non-convex simple ring about the origin.
inline Region star_region(Rng& rng, int corners) {
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * kPi * (i + 0.8 * rng.unit()) / corners;
    ring.push_back(rng.between(0.3, 1.0) * 10 * Point(std::cos(angle), std::sin(angle)));
  }
  return {{{ring, {}}}};
}

}  // namespace oxturn
