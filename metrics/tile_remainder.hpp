/// What the capsules near a tile leave uncovered of it. Private to metrics/.
///
///   TileRemainder left(capsules, margin);
///   left.compute(centre, near, chords);
///   area(left.most());                         // upper bound of the uncovered area; least(): lower bound
///
/// Method      The polygons inscribed in the capsules, nearest first, are subtracted from the tile for the upper bound,
///             the circumscribed ones for the lower bound. Where more than a few capsules are needed, the tile is
///             divided into quarters: a quarter needs only the capsules that reach it, and none is left where one of
///             them contains it.
/// Complexity  k capsules near the tile: O(k log k) where the nearest cover it; otherwise the quarters follow the
///             boundary of the union, O(k) each near it
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "metrics/capsules.hpp"

namespace oxturn {

/// A capsule near a tile.
struct NearCapsule {
  std::int64_t column;
  double distance2;  // from the tile's centre to the segment, squared
  std::uint32_t capsule;
};

class TileRemainder {
 public:
  /// `margin`: by how much polygons are shrunk or grown, in tile sides. Keeps a reference.
  TileRemainder(const std::vector<Capsule>& capsules, double margin) : capsules_(capsules), margin_(margin) {}

  void compute(Vec centre, std::span<const NearCapsule> near, const Chords& chords);
  /// Convex pieces relative to the tile's centre, of the last tile.
  const std::vector<Convex>& most() const { return most_; }
  const std::vector<Convex>& least() const { return least_; }

  /// Does the capsule certainly contain the whole tile? `distance2`: from the tile's centre to the segment, squared.
  bool covers_tile(const Capsule& capsule, double distance2, Vec centre) const;

 private:
  struct Candidate {
    double distance2;  // from the cell's centre, squared
    std::uint32_t capsule;
  };
  enum class Bound { inscribed, circumscribed };  // polygons in place of capsules
  double inner(const Capsule& k) const { return k.radius - k.slack - margin_; }
  double outer(const Capsule& k) const { return k.radius + k.slack + margin_; }
  bool covers(const Capsule& capsule, double distance2, const Extent& cell) const;
  void add_cell(const Extent& cell, std::size_t from, int depth);
  bool subtract(const Extent& cell, std::size_t from, Bound bound, bool may_stop);
  bool subtract(const Capsule& capsule, Bound bound, const Extent& where);
  void add_quarter(const Extent& quarter, std::size_t from, std::size_t to, int depth);

  const std::vector<Capsule>& capsules_;
  double margin_;
  Vec centre_{0, 0};
  const Chords* chords_ = nullptr;
  std::vector<Convex> most_, least_;
  // Working memory.
  std::vector<Candidate> candidates_;  // a stack: of the tile, of its quarter, ...
  std::vector<Convex> pieces_, parts_;
  std::vector<HalfPlane> cut_, crossing_;
};

}  // namespace oxturn
