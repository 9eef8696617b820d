/// A closed tour that drives every edge of a graph, some of them twice, at the least cost: the Chinese postman.
///
///   const std::vector<GraphEdge> edges{{0, 1, 3.0}, {1, 2, 4.0}};     // ends and the cost of driving it a second time
///   const std::vector<bool> twice = doubled_edges(3, edges);
///   for (const EdgeVisit& v : closed_tour(3, edges, twice, 0)) ...      // consecutive visits share a vertex
///
/// Doubled edges are the cheapest set that makes all degrees even (a T-join): a minimum perfect matching of the odd
/// vertices by shortest paths (Edmonds and Johnson 1973). O(k^3) for k odd vertices, and k searches in the graph.
#pragma once

#include <cstddef>
#include <vector>

namespace oxturn {

struct GraphEdge {
  std::size_t a, b;
  double cost;  // at least 0
};

/// For each edge whether it is driven twice.
std::vector<bool> doubled_edges(std::size_t vertices, const std::vector<GraphEdge>& edges);

struct EdgeVisit {
  std::size_t edge;
  bool forwards;  // from a to b
};
/// From `start` over all edges connected with it and back; `twice` as doubled_edges() says.
std::vector<EdgeVisit> closed_tour(std::size_t vertices, const std::vector<GraphEdge>& edges,
                                   const std::vector<bool>& twice, std::size_t start);

}  // namespace oxturn
