/// Loops of nodes around walls, the walk along them, and the chains that remain between invalid nodes.
///
///   for (const NodeLoop& loop : node_loops(positions, d_node)) {
///     const auto bad = invalid_nodes(loop, 0, [&](std::size_t k) { return !free(loop.at[k]); });
///     for (const NodeChain& chain : chains_of(loop, bad)) tree.attach(chain.nodes, ...);
///   }
///
/// Improving Spanning Tree Coverage (lecture slides), "Creating the Graph Nodes" to "Connected Components".
/// O(nodes), and one call of `invalid` for each node.
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "geometry/point.hpp"

namespace oxturn {

/// A loop as on the slides: an open chain of nodes whose last has the coordinates of the first. Each node lists its
/// edges; an edge is the number of the node at its other end.
struct NodeLoop {
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  struct Edges {
    std::size_t first = kNone, second = kNone;
  };
  std::vector<Point> at;
  std::vector<Edges> edges;  // nodes at the ends of the chain have one each
};

/// The given vertices in a loop, with ceil(distance / d_node - 1) nodes evenly between two neighbours; d_node > 0. The
/// first node's coordinates appear again at the very end only, because there the walk stops: a loop that touches itself
/// at its first node is cut into two. Vertices that repeat their predecessor count once; fewer than two make no loop.
std::vector<NodeLoop> node_loops(const std::vector<Point>& vertices, double d_node);

/// The walk of the slides with its variables start, previous, current, next. Its end is recognised by the coordinates,
/// and the last node is examined after the loop. Returns the invalid nodes in the order met.
std::vector<std::size_t> invalid_nodes(const NodeLoop& loop, std::size_t start,
                                       const std::function<bool(std::size_t)>& invalid);

struct NodeChain {
  Polyline nodes;
  bool closed;  // an unbroken loop: its last node repeats the first
};
/// The connected components of the loop without its bad nodes. An unbroken loop keeps its duplicated start. A broken
/// one loses it, so that the nodes on both sides of the start are one chain; each chain runs in the loop's direction.
std::vector<NodeChain> chains_of(const NodeLoop& loop, const std::vector<std::size_t>& bad);

}  // namespace oxturn
