/// Adds up covered, swept and visited areas tile by tile: the main loop of swept_area.hpp. Private to metrics/.
///
///   TileScan scan(target, origin, side, capsules, margin, &details);
///   const TileSums sums = scan.run(0.0005);
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "metrics/capsules.hpp"
#include "metrics/coverage_curve.hpp"
#include "metrics/target_rows.hpp"
#include "metrics/tile_remainder.hpp"
#include "metrics/uncovered_pieces.hpp"

namespace oxturn {

/// Areas in tiles.
struct TileSums {
  double target = 0;        // of the touched tiles
  double missed_most = 0;   // target not covered: upper bound
  double missed_least = 0;  // lower bound
  double missed = 0;        // estimate
};

/// What takes most of the time, and is left out where only the coverage counts.
struct TileDetails {
  CoverageCurve curve;
  UncoveredPieces pieces = UncoveredPieces();
  Swath swath = Swath::anywhere;
  double swept = 0;           // tiles: union of all swaths, estimate; if they lie in the target, in tiles with target
  double visits_outside = 0;  // tiles: where visits begin outside the target, estimate
};

class TileScan {
 public:
  /// Tile coordinates: (p - origin) / side. `margin`: by how much polygons are shrunk or grown, in tile sides. Keeps
  /// references to all but the region. Adds to `details` unless they are nullptr.
  TileScan(const Region& target, const Point& origin, double side, const CapsuleSet& capsules, double margin,
           TileDetails* details);

  /// `budget`: how much of a tile's target may stay undecided between the bounds. Once per object.
  TileSums run(double budget);

 private:
  /// The capsules near one tile.
  struct Tile {
    std::span<const NearCapsule> near;  // in driving order
    Vec centre;
  };
  std::int64_t first_row(std::uint32_t capsule) const;
  std::int64_t last_row(std::uint32_t capsule) const;
  std::vector<std::uint32_t> sorted_capsules() const;
  void collect(std::int64_t row, const std::vector<std::uint32_t>& active);
  void add_near(std::int64_t row, std::uint32_t capsule);
  void sort_near();
  void scan_row(std::int64_t row);
  void add_untouched(std::int64_t from, std::int64_t to);
  bool counts_outside() const;
  void scan_tile(const Tile& tile, const TileTarget& target);
  void add_details(const Tile& tile, const TileTarget& target, double left, double covered);
  bool any_covers(const Tile& tile) const;
  double uncovered(const Tile& tile);
  void compute_left(const Tile& tile, std::size_t level);
  double add_missed(const Tile& tile, const TileTarget& target, double wanted, double least);
  void add_visits(const Tile& tile, const TileTarget& target);
  std::optional<Extent> box_outside(const TileTarget& target);
  double visits_begun(const Tile& tile, const TileTarget& target, const Extent& where, const Capsule& k, Vec from);
  void clip_to_cut(const Convex& piece, std::size_t from, std::vector<Convex>& out);

  TargetRows rows_;
  const CapsuleSet& capsules_;
  TileDetails* details_;
  TileRemainder left_;  // of the present tile
  double budget_ = 0;
  double reach_;                // how far a capsule extends from its segment at most
  std::vector<Chords> chords_;  // coarse to fine
  std::size_t level_ = 0;       // of the chords that left_ was computed with
  Chords visit_chords_;
  TileSums sums_;
  // Of the present row or tile; members so that their memory is reused.
  std::vector<NearCapsule> near_, sorted_;  // by column, then in driving order
  std::vector<std::size_t> first_of_column_, fill_;
  std::vector<Convex> begun_, in_disc_;
  std::vector<HalfPlane> cut_;  // polygon of the present capsule
};

}  // namespace oxturn
