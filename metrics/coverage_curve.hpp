/// When each part of the target was covered first: covered area over path length. Private to metrics/.
///
///   CoverageCurve curve(path.length(), tiles);
///   curve.add(centre, near, capsules, target, covered);          // of each tile
///   const std::vector<CoveragePoint> points = curve.points(0.98);
///
/// Method      Each tile has the same sample points, a Fibonacci lattice. A sample belongs to the position on the path
///             at which the tool first reaches it. A tile's covered area is divided among its covered samples in the
///             target, so the sum of all is exact, and only its distribution along the path is estimated (some 10^5
///             samples in the target, at least 2 a tile). Where many capsules are near, the tile is divided into
///             quarters, of which each needs only the capsules that reach it, up to the first that contains it.
/// Complexity  a tile: O(samples x capsules near it) for few capsules, less where the first ones cover it
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "metrics/capsules.hpp"
#include "metrics/swept_area.hpp"
#include "metrics/target_rows.hpp"
#include "metrics/tile_remainder.hpp"

namespace oxturn {

class CoverageCurve {
 public:
  /// `tiles`: area of the target, in tiles.
  CoverageCurve(double length_m, double tiles);

  /// Adds a tile of which the area `covered` is covered target. `near`: in driving order.
  void add(Vec centre, std::span<const NearCapsule> near, const std::vector<Capsule>& capsules,
           const TileTarget& target, double covered);
  /// From (0, 0) to the path's end, where the share is `coverage`. Strictly ascending in path_m.
  std::vector<CoveragePoint> points(double coverage) const;

 private:
  double first_reached(const Capsule& capsule, Vec p) const;
  void collect(Vec centre, std::span<const NearCapsule> near, const std::vector<Capsule>& capsules);
  void collect_cell(const Extent& cell, std::span<Vec> samples, std::size_t from);
  void collect_each(std::span<Vec> samples, std::size_t from);
  std::size_t bin_of(double path_m) const;

  double length_m_;
  std::vector<Vec> samples_;
  std::vector<double> bins_;          // covered area by path length
  std::vector<Vec> open_;             // samples of the tile, moved as they are covered
  std::vector<std::size_t> reached_;  // bins of those that a capsule covers
  std::vector<const Capsule*> near_;  // in driving order; a stack: of the tile, of its quarter, ...
};

}  // namespace oxturn
