// The corners of a wall moved off it along their bisectors: the first step of the loops round obstacles.
//
// Source      slides "Improving Coverage" (seed improving-spanning-tree-coverage), "Bisector Vertices"
// Complexity  O(corners)
#pragma once

#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

struct BisectorNode {
  Point corner;  // of the wall
  Point at;      // off it
};

/// `wall` runs with free space at its right: counter-clockwise round an obstacle, clockwise for the outer border.
/// A node for each corner, `offset` away from both of its edges, in the wall's order; two where the corner is so sharp
/// that the one would lie farther from it than miter_limit x offset: they cut the corner at that distance. The angle at
/// a corner is the counter-clockwise one from the next to the previous edge, in (0, 2 pi), so that reflex corners are
/// right as well (the slide's arccos knows convex ones only). Repeated corners count once; a wall of fewer than two
/// corners has no nodes. No node lies farther off than the longer edge plus twice the offset (beyond that no place beside the
/// edges is off both). offset > 0, miter_limit >= 1.
std::vector<BisectorNode> bisector_nodes(const Ring& wall, double offset, double miter_limit);

}  // namespace oxturn
