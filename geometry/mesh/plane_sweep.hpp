/// The plane sweep behind boustrophedon_cells() and trapezoid_partition(). Private to geometry, not installed.
///
/// A vertical line moves along +x and stops at the vertices, those of equal x by increasing y (as if the plane were
/// sheared by an infinitesimal amount). Its status is the list of edges that it meets, ordered by exact predicates. An
/// edge is split at a vertex of another ring that lies on it. O(n log n).
#pragma once

#include "geometry/region.hpp"

namespace oxturn {

struct ChainPoint {
  Point point;
  bool is_vertex;  // of the region; otherwise a point in which the sweep line meets an edge
};
using Chain = std::vector<ChainPoint>;

/// The area between `lower` and `upper`, both from left to right and from the same x to the same x. Neither begins or
/// ends with a vertical edge.
struct PlaneSweepCell {
  Chain lower, upper;
};

enum class Cuts {
  critical,      // only where the line through a vertex extends into free space both upwards and downwards
  every_vertex,  // from every vertex upwards and downwards to the first wall
};

/// The cells in the order in which the line opens them, those without width left out. Throws std::invalid_argument
/// where edges cross or overlap.
std::vector<PlaneSweepCell> plane_sweep_cells(const Region& region, Cuts cuts);

}  // namespace oxturn
