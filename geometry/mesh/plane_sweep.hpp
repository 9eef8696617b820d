// Private to geometry: the plane sweep behind boustrophedon_cells and trapezoid_partition.
//
// A vertical line moves along +x over the corners, equal x by rising y (as if the plane were sheared by an
// infinitesimal amount). The status holds the edges under the line, ordered by exact predicates. Edges on which
// another ring's corner lies are split there. O(n log n).
#pragma once

#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

struct ChainPoint {
  Point place;
  bool corner;  // of the region; else where a cut meets an edge
};
using Chain = std::vector<ChainPoint>;

/// Between `lower` and `upper`, left to right. Both begin at the same x and end at the same x, and neither begins or
/// ends with a vertical stretch. Cells without width are left out.
struct PlaneSweepCell {
  Chain lower, upper;
};

enum class Cuts {
  critical,      // only where the line through a corner extends both up and down into free space
  every_corner,  // up and down from every corner to the first wall
};

/// In the order in which the line opens them. Throws std::invalid_argument where edges cross or overlap.
std::vector<PlaneSweepCell> plane_sweep_cells(const Region& region, Cuts cuts);

}  // namespace oxturn
