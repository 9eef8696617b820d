/// Which points of free space are still uncovered, on a lattice of a quarter of a cell. Covering and queries may
/// alternate.
///
///   UncoveredSamples samples(cells, problem.map().free, tool_width / 2);
///   samples.cover(a, b);
///   if (samples.any_uncovered(i, j)) ...
///
/// Build O(samples + vertices), a byte a sample; covering O(rows of samples that meet the segment's capsule).
#pragma once

#include "algorithms/lattice/grid_graph.hpp"
#include "geometry/raster.hpp"

namespace oxturn {

class UncoveredSamples {
 public:
  /// Samples over the cells of `cells` and a margin of one cell on every side; those in `free` are uncovered. `reach`:
  /// metres from the path.
  UncoveredSamples(const GridGraph& cells, const Region& free, double reach);
  /// Everything within reach of the segment is covered from now on.
  void cover(const Point& a, const Point& b);

  /// Counts the sample as covered.
  void drop(int i, int j, int k) { bits_.bits[bits_.at(column(i, k), row(j, k))] = 0; }

  static constexpr int kPerCell = 16;
  /// The k-th sample of a cell, row by row. Cells are counted from -1 on, because of the margin.
  bool uncovered(int i, int j, int k) const { return bits_.bits[bits_.at(column(i, k), row(j, k))] != 0; }
  bool any_uncovered(int i, int j) const;
  Point position(int i, int j, int k) const { return cells_.centre(i + (k % 4 - 1.5) / 4, j + (k / 4 - 1.5) / 4); }

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
