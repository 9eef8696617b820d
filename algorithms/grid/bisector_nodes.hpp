/// The vertices of a wall moved away from it along their bisectors: the first step of the loops around obstacles.
///
///   for (const BisectorNode& node : bisector_nodes(wall, offset, 2)) loop.push_back(node.at);
///
/// Improving Spanning Tree Coverage (lecture slides), "Bisector Vertices". O(vertices).
#pragma once

#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

struct BisectorNode {
  Point vertex;  // of the wall
  Point at;      // away from it
};

/// `wall` has free space on its right: counter-clockwise around an obstacle, clockwise for the outer boundary. offset >
/// 0, miter_limit >= 1.
/// Returns a node for each vertex in the wall's order, `offset` away from both of its edges; two nodes where the vertex
/// is so sharp that one would lie farther away than miter_limit * offset: they cut it at that distance. The angle at a
/// vertex is the counter-clockwise one from the next edge to the previous one, in (0, 2 pi), so that reflex vertices
/// are right as well (the arccos on the slide is right for convex ones only). Repeated vertices count once; a wall of
/// fewer than two has no nodes. No node is farther away than the longer edge plus twice the offset, beyond which no
/// point beside the edges is off both.
std::vector<BisectorNode> bisector_nodes(const Ring& wall, double offset, double miter_limit);

}  // namespace oxturn
