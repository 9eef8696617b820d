/// Least 1-trees: a spanning tree, and the second edge of one of its leaves.
///
///   const OneTree tree = sparse_one_tree(graph, cost_of_edge);
///   const OneTree tree = complete_one_tree(n, cost_between);
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "algorithms/tour/connection_cost.hpp"

namespace oxturn {

struct OneTree {
  double cost = 0;
  std::vector<std::pair<ElementId, ElementId>> edges;  // n of them
};

/// An undirected graph as lists of neighbours; must be connected.
using SparseGraph = std::vector<std::vector<ElementId>>;
using EdgeCost = std::function<double(ElementId, ElementId)>;

/// The leaf is the one whose second edge is dearest. Prim's algorithm: O(m log m) for m edges, O(n^2) if complete.
OneTree sparse_one_tree(const SparseGraph& graph, const EdgeCost& cost);
OneTree complete_one_tree(std::size_t n, const EdgeCost& cost);

}  // namespace oxturn
