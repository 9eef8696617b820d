/// Cells around a cell, ring by ring: for searches outwards in a grid.
///
///   for (int ring = 0; ring <= last && !found; ++ring)
///     for_each_in_ring(ci, cj, ring, columns, rows, [&](int i, int j) { ... });
///
///   2 2 2 2 2
///   2 1 1 1 2
///   2 1 0 1 2
///   2 1 1 1 2
///   2 2 2 2 2
#pragma once

#include <algorithm>

namespace oxturn {

/// Calls f(i, j) for the cells of the ring that lie in the grid, row by row.
template <class F>
void for_each_in_ring(int ci, int cj, int ring, int columns, int rows, F f) {
  for (int j = std::max(0, cj - ring); j <= std::min(rows - 1, cj + ring); ++j) {
    const bool whole_row = ring == 0 || j == cj - ring || j == cj + ring;
    for (int i = ci - ring; i <= ci + ring; i += whole_row ? 1 : 2 * ring)
      if (i >= 0 && i < columns) f(i, j);
  }
}

}  // namespace oxturn
