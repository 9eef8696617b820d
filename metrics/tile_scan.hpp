/// Adds up covered, swept and visited areas tile by tile: the main loop of swept_area.hpp. Private to metrics/.
///
///   TileScan scan(target, origin, side, capsules, margin);
///   const TileSums sums = scan.run(0.0005);
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "metrics/capsules.hpp"
#include "metrics/coverage_curve.hpp"
#include "metrics/target_rows.hpp"
#include "metrics/uncovered_pieces.hpp"

namespace oxturn {

inline constexpr double kToolRadius = 1;  // in tile sides

/// Areas in tiles.
struct TileSums {
  double target = 0;          // of the touched tiles
  double missed_most = 0;     // target not covered: upper bound
  double missed_least = 0;    // lower bound
  double missed = 0;          // estimate
  double swept = 0;           // union of all swaths, estimate
  double visits_outside = 0;  // where visits begin outside the target, estimate
};

class TileScan {
 public:
  /// Tile coordinates: (p - origin) / side. `margin`: by how much polygons are shrunk or grown, in tile sides. Keeps
  /// references to all but the region.
  TileScan(const Region& target, const Point& origin, double side, const CapsuleSet& capsules, double margin,
           CoverageCurve& curve, UncoveredPieces& pieces);

  /// `budget`: how much of a tile's target may stay undecided between the bounds. Once per object.
  TileSums run(double budget);

 private:
  /// The capsules near one tile.
  struct Tile {
    std::span<const NearCapsule> near;  // in driving order
    Vec centre;
  };
  enum class Bound { inscribed, circumscribed };  // polygons in place of capsules
  struct Uncovered {                              // of one tile
    double most = 0, least = 0;
    double estimate() const;
  };
  std::int64_t first_row(std::uint32_t capsule) const;
  std::int64_t last_row(std::uint32_t capsule) const;
  void collect(std::int64_t row, const std::vector<std::uint32_t>& active);
  void add_near(std::int64_t row, std::uint32_t capsule);
  void sort_near();
  void scan_row(std::int64_t row);
  void add_untouched(std::int64_t from, std::int64_t to);
  void scan_tile(const Tile& tile, const TileTarget& target);
  bool covers_tile(const NearCapsule& near, Vec centre) const;
  bool any_covers(const Tile& tile) const;
  void remainder(Vec centre, const Chords& chords, Bound bound, std::vector<Convex>& pieces);
  Uncovered uncovered(const Tile& tile);
  double add_missed(const Tile& tile, const TileTarget& target, double wanted);
  void add_visits(const Tile& tile, const TileTarget& target);
  double visits_begun(const Tile& tile, const TileTarget& target, const Capsule& k, Vec from, double cap);
  void clip_to_cut(Convex piece, std::size_t from);

  TargetRows rows_;
  const CapsuleSet& capsules_;
  CoverageCurve& curve_;
  UncoveredPieces& pieces_;
  double margin_, budget_ = 0;
  double reach_;                // how far a capsule extends from its segment at most
  std::vector<Chords> chords_;  // coarse to fine
  Chords visit_chords_;
  TileSums sums_;
  // Of the present row or tile; members so that their memory is reused.
  std::vector<NearCapsule> near_, sorted_;  // by column, then in driving order
  std::vector<NearCapsule> nearest_;        // of the tile, nearest first
  std::vector<std::size_t> first_of_column_, fill_;
  std::vector<Convex> most_, least_;  // what remains uncovered of the present tile, upper and lower bound
  std::vector<Convex> spare_;
  std::vector<HalfPlane> cut_;  // polygon of the present capsule
};

}  // namespace oxturn
