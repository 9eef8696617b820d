#include "algorithms/tour/one_tree.hpp"

#include <limits>
#include <queue>

namespace oxturn {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// Adds the second edge of the leaf at which it is dearest. `neighbours(e, f)` calls f(other) for each edge of e.
template <class Neighbours>
void add_leaf_edge(OneTree& tree, std::size_t n, const EdgeCost& cost, Neighbours neighbours) {
  std::vector<std::uint32_t> degree(n, 0);
  std::vector<ElementId> partner(n, 0);
  for (const auto& [a, b] : tree.edges) {
    ++degree[a];
    ++degree[b];
    partner[a] = b;
    partner[b] = a;
  }
  double dearest = -kNone;
  std::pair<ElementId, ElementId> edge{0, 0};
  for (ElementId e = 0; e < n; ++e) {
    if (degree[e] != 1) continue;
    double least = kNone;
    ElementId second = partner[e];
    neighbours(e, [&](ElementId other) {
      if (other == partner[e]) return;
      if (const double c = cost(e, other); c < least) {
        least = c;
        second = other;
      }
    });
    if (least == kNone || least <= dearest) continue;
    dearest = least;
    edge = {e, second};
  }
  tree.edges.push_back(edge);
  tree.cost += dearest;
}

}  // namespace

OneTree sparse_one_tree(const SparseGraph& graph, const EdgeCost& cost) {
  struct Offer {
    double cost;
    ElementId to, from;
    bool operator>(const Offer& o) const { return cost != o.cost ? cost > o.cost : to > o.to; }
  };
  OneTree tree;
  std::vector<double> best(graph.size(), kNone);
  std::vector<bool> done(graph.size(), false);
  std::priority_queue<Offer, std::vector<Offer>, std::greater<>> open;
  open.push({0, 0, 0});
  while (!open.empty()) {
    const Offer at = open.top();
    open.pop();
    if (done[at.to]) continue;
    done[at.to] = true;
    if (at.to != 0) {
      tree.edges.push_back({at.from, at.to});
      tree.cost += at.cost;
    }
    for (const ElementId other : graph[at.to]) {
      if (done[other]) continue;
      const double c = cost(at.to, other);
      if (c >= best[other]) continue;
      best[other] = c;
      open.push({c, other, at.to});
    }
  }
  add_leaf_edge(tree, graph.size(), cost, [&](ElementId e, auto visit) {
    for (const ElementId other : graph[e]) visit(other);
  });
  return tree;
}

OneTree complete_one_tree(std::size_t n, const EdgeCost& cost) {
  OneTree tree;
  std::vector<double> best(n, kNone);
  std::vector<ElementId> from(n, 0);
  std::vector<bool> done(n, false);
  ElementId at = 0;
  for (std::size_t k = 1; k < n; ++k) {
    done[at] = true;
    ElementId nearest = at;
    for (ElementId e = 0; e < n; ++e) {
      if (done[e]) continue;
      if (const double c = cost(at, e); c < best[e]) {
        best[e] = c;
        from[e] = at;
      }
      if (nearest == at || best[e] < best[nearest]) nearest = e;
    }
    tree.edges.push_back({from[nearest], nearest});
    tree.cost += best[nearest];
    at = nearest;
  }
  add_leaf_edge(tree, n, cost, [&](ElementId e, auto visit) {
    for (ElementId other = 0; other < n; ++other)
      if (other != e) visit(other);
  });
  return tree;
}

}  // namespace oxturn
