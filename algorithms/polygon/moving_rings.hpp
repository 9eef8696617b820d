/// The rings of a polygon's insets, as they move inwards.
///
///   const MovingRings rings(straight_skeleton(polygon));
///   for (MovingRing ring : rings.begin()) {
///     const Polyline lap = rings.closed(ring, 0);
///     std::vector<MovingRing> later = rings.advance(ring, 0.4);       // none: it has vanished; several: split
///   }
///
/// All insets are read off one straight skeleton: the vertices of a ring are the arcs alive at its time, and its edges
/// lie in faces. So a point of a ring keeps its position, on an arc or between two, whatever edges vanish elsewhere.
/// O(k log k) for a ring with k vertices and what lies between the two times.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/mesh/straight_skeleton.hpp"

namespace oxturn {

/// Its vertices, in order: arcs of the skeleton.
struct MovingRing {
  std::vector<std::size_t> arcs = {};
};

class MovingRings {
 public:
  explicit MovingRings(StraightSkeleton skeleton);

  /// At time 0.
  std::vector<MovingRing> begin() const;
  /// What becomes of a ring until a later time.
  std::vector<MovingRing> advance(const MovingRing& ring, double to) const;
  /// Is a ring of one time a single one at a later time? Other than advance(), without looking at all of it.
  bool single(const MovingRing& ring, double time, double to) const;
  /// When a ring of one time splits, if it is not single from then on until a later time. Without looking at all of it.
  std::optional<double> split_until(const MovingRing& ring, double time, double to) const;
  /// A vertex of a ring at a later time, if it exists then.
  std::optional<Point> later(std::size_t arc, double to) const;
  /// The arc that continues it, if any.
  std::optional<std::size_t> follow(std::size_t arc, double to) const;
  Point at(std::size_t arc, double time) const;
  /// The whole ring, its first vertex repeated at the end.
  Polyline closed(const MovingRing& ring, double time) const;

 private:
  bool alive(std::size_t arc, double time) const;
  std::vector<MovingRing> linked(const std::vector<std::size_t>& arcs, double time) const;
  std::vector<std::size_t> followed(const std::vector<std::size_t>& arcs, double to, bool first_only) const;
  void find_branches();
  std::size_t branch_at(const MovingRing& ring, double time) const;
  std::ptrdiff_t parts_left(std::size_t branch, double to) const;

  /// A part of the polygon's inside as it shrinks, until it splits into `parts` or vanishes.
  struct Branch {
    double end;   // metres
    double last;  // when the last of its parts vanishes
    std::vector<std::size_t> parts = {};
    std::optional<std::size_t> whole = {};  // whose part it is
  };
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  StraightSkeleton skeleton_;
  std::vector<std::vector<std::size_t>> at_node_;  // arcs, by node
  std::vector<Branch> branches_;
  std::vector<std::size_t> branch_;          // that ends at a node or passes it, by node
  mutable std::vector<std::uint32_t> seen_;  // by arc: the last walk that came by
  mutable std::uint32_t walks_ = 0;
  mutable std::vector<std::size_t> end_in_face_;  // of linked(): the last one, by face; none between calls
};

}  // namespace oxturn
