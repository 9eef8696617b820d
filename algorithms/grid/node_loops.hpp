// Loops of nodes round walls, the walk along them, and what is left of them between invalid nodes.
//
// Source      slides "Improving Coverage" (seed improving-spanning-tree-coverage), "Creating the Graph Nodes" to
//             "Connected Components"
// Complexity  O(nodes), and one question each for node and edge
#pragma once

#include <functional>
#include <limits>
#include <vector>

#include "geometry/point.hpp"

namespace oxturn {

/// A loop as the slides keep it: an open chain of nodes whose last has the coordinates of the first. Each node lists
/// its edges; an edge is the number of the node at the other end.
struct NodeLoop {
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
  struct Edges {
    std::size_t first = kNone, second = kNone;
  };
  std::vector<Point> at;
  std::vector<Edges> edges;  // nodes at the ends of the loop have one each
};

/// The given corners in a loop, with ceil(dist / d_node - 1) nodes between two neighbours, evenly. The first node's
/// coordinates come again at the very end only, as the walk stops there: a loop that touches itself in them is cut in
/// two. Corners that repeat their predecessor count once; fewer than two make no loop. d_node > 0.
std::vector<NodeLoop> node_loops(const std::vector<Point>& corners, double d_node);

/// The slides' walk: start, previous, current, next; the end is known by its coordinates, and the last node is looked
/// at after the loop. Returns the invalid nodes in the order met.
std::vector<std::size_t> invalid_nodes(const NodeLoop& loop, std::size_t start,
                                       const std::function<bool(std::size_t)>& invalid);

/// What hangs together once the bad nodes are gone, each from its start node on.
struct NodeChain {
  Polyline nodes;
  bool closed;  // an unbroken loop: its last node repeats the start
};
/// An unbroken loop keeps its duplicated start. A broken one loses it, so that what lies on both sides of it is one
/// chain; each chain starts at its free end, in the loop's direction.
std::vector<NodeChain> chains_of(const NodeLoop& loop, const std::vector<std::size_t>& bad);

}  // namespace oxturn
