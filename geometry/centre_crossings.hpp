/// Where a region's edges pass between the centres of cells; decided by exact predicates.
///
///   for_each_centre_crossing(region, grid, flip, on_edge);
///
/// Calls flip(k, j) for each row j that an edge meets, where k is the first column whose centre is strictly to the
/// right of the edge, unless there is none: a centre lies in the region if an odd number of flips are at its column or
/// to the left of it. Calls on_edge(i, j) for the centres exactly on an edge, which lie in it as well. `grid` has the
/// members origin, cell, columns and rows of a BitGrid.
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/predicates.hpp"
#include "geometry/region.hpp"

namespace oxturn {

template <class Grid, class Flip, class OnEdge>
void for_each_centre_crossing(const Region& region, const Grid& grid, Flip flip, OnEdge on_edge) {
  const auto clamped = [](double x, int low, int high) { return static_cast<int>(std::clamp<double>(x, low, high)); };
  const auto centre = [&](int i, int j) -> Point { return grid.origin + grid.cell * Point(i + 0.5, j + 0.5); };
  for_each_edge(region, [&](const Point& from, const Point& to) {
    const Point &a = from.y() <= to.y() ? from : to, &b = from.y() <= to.y() ? to : from;  // a below b
    const int first = clamped(std::floor((a.y() - grid.origin.y()) / grid.cell - 0.5) - 1, 0, grid.rows);
    const int last = clamped(std::ceil((b.y() - grid.origin.y()) / grid.cell - 0.5) + 1, -1, grid.rows - 1);
    for (int j = first; j <= last; ++j) {
      const double y = centre(0, j).y();
      if (y < a.y() || y > b.y()) continue;
      if (a.y() == b.y()) {
        const double low = std::min(a.x(), b.x()), high = std::max(a.x(), b.x());
        for (int i = clamped((low - grid.origin.x()) / grid.cell - 2, 0, grid.columns); i < grid.columns; ++i) {
          const double x = centre(i, j).x();
          if (x > high) break;
          if (x >= low) on_edge(i, j);
        }
        continue;
      }
      // k: estimated, and then corrected by the exact predicate.
      const double x = a.x() + (y - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
      int k = clamped(std::ceil((x - grid.origin.x()) / grid.cell - 0.5), 0, grid.columns);
      while (k > 0 && orientation(a, b, centre(k - 1, j)) < 0) --k;
      while (k < grid.columns && orientation(a, b, centre(k, j)) >= 0) {
        if (orientation(a, b, centre(k, j)) == 0) on_edge(k, j);
        ++k;
      }
      if (k > 0 && orientation(a, b, centre(k - 1, j)) == 0) on_edge(k - 1, j);
      if (y < b.y() && k < grid.columns) flip(k, j);  // an edge includes its lower end only
    }
  });
}

}  // namespace oxturn
