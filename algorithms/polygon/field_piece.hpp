/// A polygon of what is left of a field, and the stretches of its boundary. Not installed.
///
///   const FieldPiece piece(polygon);
///   std::deque<Stretch> rounds;
///   piece.for_each_stretch(robot, rounds, [&](const Stretch& s) { /* s.points, between sharp turns */ });
///
/// Source      Oksanen and Visala 2009, second algorithm: a route ends where the field's edge turns
/// Complexity  O(n) for n vertices; contains() as EdgeRows
#pragma once

#include <deque>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/edge_rows.hpp"
#include "geometry/region.hpp"

namespace oxturn {

/// A part of a ring between turns above 45 degrees, in the ring's sense; metres and radians.
struct Stretch {
  Polyline points;
  double metres = 0;
  double round_metres = 0, round_turns = 0;  // of the whole ring, whichever side each turn is to
};

class FieldPiece {
 public:
  explicit FieldPiece(Polygon polygon);
  const Region& region() const { return region_; }
  const Box& box() const { return box_; }
  bool contains(const Point& p) const;

  /// Rings without sharp turns are one stretch, which begins at the vertex nearest to `at`: `rounds` gets these, and
  /// keeps them. The others live as long as the piece.
  template <class F>
  void for_each_stretch(const Point& at, std::deque<Stretch>& rounds, F f) const {
    for (const Stretch& s : stretches_) f(s);
    for (const auto& [ring, round] : smooth_) f(rounds.emplace_back(all_round(ring, at, round)));
  }

 private:
  static Stretch all_round(const Ring& ring, const Point& at, const Stretch& round);
  void add_stretches(const Ring& ring);

  Region region_;
  mutable std::optional<EdgeRows> rows_;  // made when first needed: many pieces are cut again before
  Box box_;
  std::vector<Stretch> stretches_;
  std::vector<std::pair<Ring, Stretch>> smooth_;
};

}  // namespace oxturn
