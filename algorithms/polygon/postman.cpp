#include "algorithms/polygon/postman.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <queue>
#include <utility>

#include "algorithms/polygon/perfect_matching.hpp"

namespace oxturn {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr double kSteps = 1e6;  // costs are rounded to so many parts of the dearest path

struct Paths {
  std::vector<double> cost;       // by vertex
  std::vector<std::size_t> edge;  // by which the vertex is reached
};

class Graph {
 public:
  Graph(std::size_t vertices, const std::vector<GraphEdge>& edges) : edges_(edges), at_(vertices) {
    for (std::size_t e = 0; e < edges.size(); ++e) {
      at_[edges[e].a].push_back(e);
      at_[edges[e].b].push_back(e);
    }
  }
  std::size_t other(std::size_t e, std::size_t v) const { return edges_[e].a == v ? edges_[e].b : edges_[e].a; }
  std::vector<std::size_t> odd() const {
    std::vector<std::size_t> all;
    for (std::size_t v = 0; v < at_.size(); ++v)
      if (at_[v].size() % 2 == 1) all.push_back(v);
    return all;
  }
  /// Dijkstra.
  Paths from(std::size_t start) const {
    Paths paths{std::vector<double>(at_.size(), kFar), std::vector<std::size_t>(at_.size(), edges_.size())};
    using Item = std::pair<double, std::size_t>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
    paths.cost[start] = 0;
    open.push({0, start});
    while (!open.empty()) {
      const auto [cost, v] = open.top();
      open.pop();
      if (cost > paths.cost[v]) continue;
      for (const std::size_t e : at_[v])
        if (const std::size_t to = other(e, v); cost + edges_[e].cost < paths.cost[to]) {
          paths.cost[to] = cost + edges_[e].cost;
          paths.edge[to] = e;
          open.push({paths.cost[to], to});
        }
    }
    return paths;
  }

 private:
  const std::vector<GraphEdge>& edges_;
  std::vector<std::vector<std::size_t>> at_;
};

}  // namespace

std::vector<bool> doubled_edges(std::size_t vertices, const std::vector<GraphEdge>& edges) {
  const Graph graph(vertices, edges);
  const std::vector<std::size_t> odd = graph.odd();
  std::vector<Paths> paths;
  double dearest = 0;
  for (const std::size_t v : odd) {
    paths.push_back(graph.from(v));
    for (const std::size_t o : odd)
      if (paths.back().cost[o] < kFar) dearest = std::max(dearest, paths.back().cost[o]);
  }
  const double unit = dearest > 0 ? dearest / kSteps : 1;
  const std::vector<std::size_t> mate = perfect_matching(odd.size(), [&](std::size_t i, std::size_t j) {
    const double cost = paths[std::min(i, j)].cost[odd[std::max(i, j)]];
    // Not connected: so dear that no such pair is in the cheapest matching, because each component has an even number.
    return cost < kFar ? std::llround(cost / unit) : static_cast<std::int64_t>(kSteps) * std::ssize(odd);
  });
  std::vector<bool> twice(edges.size(), false);
  for (std::size_t i = 0; i < odd.size(); ++i) {
    if (mate[i] < i) continue;
    for (std::size_t v = odd[mate[i]]; v != odd[i]; v = graph.other(paths[i].edge[v], v))
      twice[paths[i].edge[v]] = !twice[paths[i].edge[v]];  // the symmetric difference of all paths
  }
  return twice;
}

std::vector<EdgeVisit> closed_tour(std::size_t vertices, const std::vector<GraphEdge>& edges,
                                   const std::vector<bool>& twice, std::size_t start) {
  std::vector<int> left(edges.size());
  std::vector<std::vector<std::size_t>> at(vertices);  // edges, once for each visit
  for (std::size_t e = 0; e < edges.size(); ++e) {
    left[e] = twice[e] ? 2 : 1;
    for (int k = 0; k < left[e]; ++k)
      for (const std::size_t v : {edges[e].a, edges[e].b}) at[v].push_back(e);
  }
  for (std::vector<std::size_t>& all : at) std::reverse(all.begin(), all.end());  // taken from the back
  struct Step {
    std::size_t vertex;
    EdgeVisit by;  // how the vertex was reached
  };
  std::vector<Step> stack{{start, {edges.size(), true}}};
  std::vector<EdgeVisit> tour;
  while (!stack.empty()) {  // Hierholzer
    const std::size_t v = stack.back().vertex;
    while (!at[v].empty() && left[at[v].back()] == 0) at[v].pop_back();
    if (at[v].empty()) {
      if (stack.size() > 1) tour.push_back(stack.back().by);
      stack.pop_back();
      continue;
    }
    const std::size_t e = at[v].back();
    at[v].pop_back();
    --left[e];
    const bool forwards = edges[e].a == v;
    stack.push_back({forwards ? edges[e].b : edges[e].a, {e, forwards}});
  }
  std::reverse(tour.begin(), tour.end());
  return tour;
}

}  // namespace oxturn
