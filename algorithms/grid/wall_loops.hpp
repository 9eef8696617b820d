/// Loops of nodes around walls, and the chains that remain between invalid nodes.
///
///   std::vector<Point> vertices;
///   for (const BisectorNode& node : bisector_nodes(wall, offset, 2)) vertices.push_back(node.at);
///   for (const Polyline& loop : node_loops(vertices, d_node))
///     for (const NodeChain& chain : chains_of(loop, outside(loop))) tree.attach(chain.nodes, ...);
///
/// Source      "Improving Spanning Tree Coverage" (lecture slides), "Bisector Vertices" to "Connected Components".
/// O(vertices + nodes).
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
/// are right as well (the source's arccos is right for convex ones only). Repeated vertices count once; a wall of
/// fewer than two has no nodes. No node is farther away than the longer edge plus twice the offset, beyond which no
/// point beside the edges is off both.
std::vector<BisectorNode> bisector_nodes(const Ring& wall, double offset, double miter_limit);

/// Loops of nodes as in the source: open chains whose last node has the coordinates of the first. The given vertices in
/// a loop, with ceil(distance / d_node - 1) nodes evenly between two neighbours; d_node > 0. The first node's
/// coordinates appear again at the very end only, because there the source's walk along the loop stops: a loop that
/// touches itself at its first node is cut into two. Vertices that repeat their predecessor count once; fewer than two
/// make no loop.
std::vector<Polyline> node_loops(const std::vector<Point>& vertices, double d_node);

struct NodeChain {
  Polyline nodes;
  bool closed;  // an unbroken loop: its last node repeats the first
};
/// The connected components of the loop without its invalid nodes (the first and the last are the same). An unbroken
/// loop keeps its duplicated start. A broken one loses it, so that the nodes on both sides of the start are one chain;
/// each chain runs in the loop's direction.
std::vector<NodeChain> chains_of(const Polyline& loop, const std::vector<bool>& invalid);

}  // namespace oxturn
