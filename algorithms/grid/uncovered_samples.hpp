// What of free space is still bare, on a lattice of a quarter of a cell: to be swept, and asked, at any time.
//
// Complexity  build O(samples + corners), a byte a sample; sweeping O(rows of samples that a segment's capsule meets)
#pragma once

#include "algorithms/lattice/grid_graph.hpp"
#include "geometry/raster.hpp"

namespace oxturn {

class UncoveredSamples {
 public:
  /// Samples over the cells of `cells` and one cell more on every side; those in `free` are bare. `reach`: metres.
  UncoveredSamples(const GridGraph& cells, const Region& free, double reach);
  /// Everything within reach of the segment is bare no more.
  void sweep(const Point& a, const Point& b);

  static constexpr int kPerCell = 16;
  /// The k-th sample of a cell, row by row; columns and rows of cells from -1 on.
  bool bare(int i, int j, int k) const { return bits_.bits[bits_.at(column(i, k), row(j, k))] != 0; }
  /// Of all of a cell's samples, is any bare?
  bool any_uncovered(int i, int j) const;
  Point place(int i, int j, int k) const { return cells_.centre(i + (k % 4 - 1.5) / 4, j + (k / 4 - 1.5) / 4); }

 private:
  static int column(int i, int k) { return 4 * (i + 1) + k % 4; }
  static int row(int j, int k) { return 4 * (j + 1) + k / 4; }
  /// In samples: sample (i, j) is the point (i, j).
  Point coordinates(const Point& p) const { return 4 * cells_.coordinates(p) + Point(5.5, 5.5); }

  const GridGraph& cells_;
  double reach_;  // in samples
  BitGrid bits_;
};

}  // namespace oxturn
