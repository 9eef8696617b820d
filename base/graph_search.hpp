/// Graph searches: breadth-first, Dijkstra, A*, connected components. The graph is a function that names the neighbours
/// of a node; nothing is stored or copied, and the compiler sees through the call.
///
///   std::vector<Cell> reached{start};                     // breadth-first: any type of node, the caller's marks
///   breadth_first(reached, [&](const Cell& at, auto reach) {
///     for (const Cell& next : neighbours(at))
///       if (mark(next)) reach(next);
///   });
///
///   SearchTree<double> tree;                              // Dijkstra: nodes are 0 .. n-1
///   dijkstra(tree, n, start, [&](std::size_t at, auto reach) {
///     for (const Edge& e : edges[at]) reach(e.to, e.length);
///   }, [&](std::size_t at) { return at == goal; });
///   tree.path_to(goal);                                   // start, ..., goal
///
/// Deterministic: of nodes at equal cost the one with the lowest number is settled first, and of equally cheap paths to
/// a node the one found first is kept. Breadth-first keeps the order in which nodes were reached.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace oxturn {

/// Breadth-first search from the nodes in `queue`, to which every reached node is appended in the order of its
/// distance. `expand(node, reach)` marks the neighbours not yet reached and calls reach(neighbour) for each; the caller
/// has marked the first nodes. Stops at the first node with goal(node) and returns its index in `queue`; nullopt if
/// there is none. O(nodes + edges).
template <class Node, class Expand, class Goal>
std::optional<std::size_t> breadth_first(std::vector<Node>& queue, Expand expand, Goal goal) {
  for (std::size_t k = 0; k < queue.size(); ++k) {
    const Node at = queue[k];
    if (goal(at)) return k;
    expand(at, [&queue](const Node& next) { queue.push_back(next); });
  }
  return std::nullopt;
}
/// The same without a goal: visits all that can be reached.
template <class Node, class Expand>
void breadth_first(std::vector<Node>& queue, Expand expand) {
  breadth_first(queue, expand, [](const Node&) { return false; });
}

/// The connected component of each node, numbered from 0 in the order of their lowest nodes.
struct ConnectedComponents {
  static constexpr std::int32_t kNone = -1;  // of nodes that are left out
  std::vector<std::int32_t> of;
  std::int32_t count = 0;
};
/// Of an undirected graph on the nodes 0 .. n-1 for which `contains(node)` is true. `neighbours(node, reach)` calls
/// reach(neighbour) for each neighbour; those left out are ignored. O(nodes + edges).
template <class Contains, class Neighbours>
ConnectedComponents connected_components(std::size_t n, Contains contains, Neighbours neighbours) {
  ConnectedComponents components{std::vector<std::int32_t>(n, ConnectedComponents::kNone), 0};
  std::vector<std::size_t> stack;
  const auto reach = [&](std::size_t node) {
    if (components.of[node] != ConnectedComponents::kNone || !contains(node)) return;
    components.of[node] = components.count;
    stack.push_back(node);
  };
  for (std::size_t first = 0; first < n; ++first) {
    reach(first);
    if (stack.empty()) continue;
    while (!stack.empty()) {
      const std::size_t node = stack.back();
      stack.pop_back();
      neighbours(node, reach);
    }
    ++components.count;
  }
  return components;
}
template <class Neighbours>
ConnectedComponents connected_components(std::size_t n, Neighbours neighbours) {
  return connected_components(
      n, [](std::size_t) { return true; }, neighbours);
}

/// Where a search begins: nodes, each with the cost to begin with there. Any contiguous container of pairs.
template <class Cost>
using SearchSources = std::type_identity_t<std::span<const std::pair<std::size_t, Cost>>>;

/// What Dijkstra and A* find out about the nodes 0 .. n-1: cost and predecessor. May be reused: a further search does
/// not clear it, and so pays only for the nodes that it reaches. Cost is an arithmetic type; n < 2^31.
template <class Cost>
class SearchTree {
 public:
  /// Reached by the last search; settled too, if the search got as far.
  bool reached(std::size_t node) const { return node < notes_.size() && notes_[node].search == search_; }
  /// The node's cost is final.
  bool settled(std::size_t node) const { return reached(node) && notes_[node].settled; }
  /// Of a reached node: the least cost found.
  Cost cost(std::size_t node) const { return notes_[node].cost; }
  /// Of a reached node: the one before it on its path; nullopt for a source.
  std::optional<std::size_t> predecessor(std::size_t node) const {
    if (notes_[node].predecessor == kSource) return std::nullopt;
    return notes_[node].predecessor;
  }
  /// The path to a reached node, its source first.
  std::vector<std::size_t> path_to(std::size_t node) const {
    std::vector<std::size_t> path{node};
    while (const auto before = predecessor(path.back())) path.push_back(*before);
    std::reverse(path.begin(), path.end());
    return path;
  }

 private:
  template <class C, class Neighbours, class Goal, class Estimate>
  friend std::optional<std::size_t> a_star(SearchTree<C>& tree, std::size_t n, SearchSources<C> sources,
                                           Neighbours neighbours, Goal goal, Estimate estimate);

  static constexpr std::uint32_t kSource = 0x7fffffff;
  struct Note {
    Cost cost{};
    std::uint32_t search = 0;  // the number of the search that reached the node
    std::uint32_t predecessor : 31 = kSource;
    std::uint32_t settled : 1 = 0;
  };

  void begin(std::size_t n) {
    open_.clear();
    if (++search_ == 0) {  // the counter has come round
      notes_.clear();
      search_ = 1;
    }
    if (notes_.size() < n) notes_.resize(n);
  }
  /// False if the node is settled or was reached at this cost or a lower one.
  bool improve(std::size_t node, Cost cost, std::uint32_t predecessor) {
    Note& note = notes_[node];
    if (note.search == search_ && (note.settled || !(cost < note.cost))) return false;
    note.cost = cost;
    note.search = search_;
    note.predecessor = predecessor & kSource;
    note.settled = 0;
    return true;
  }
  void push(Cost priority, std::size_t node) {
    open_.push_back({priority, static_cast<std::uint32_t>(node)});
    std::push_heap(open_.begin(), open_.end(), std::greater<>());
  }
  /// The open node of the lowest priority, settled from now on; nullopt if there is none left.
  std::optional<std::size_t> settle_next() {
    while (!open_.empty()) {
      std::pop_heap(open_.begin(), open_.end(), std::greater<>());
      const std::size_t node = open_.back().second;
      open_.pop_back();
      if (notes_[node].settled) continue;
      notes_[node].settled = 1;
      return node;
    }
    return std::nullopt;
  }

  std::vector<Note> notes_;
  std::vector<std::pair<Cost, std::uint32_t>> open_;  // a heap, the least (priority, node) first
  std::uint32_t search_ = 0;
};

/// A* from `sources` (node, its cost). `neighbours(node, reach)` calls reach(neighbour, length of the edge), at least
/// 0, for each neighbour; reach says whether that is the best path to the neighbour so far. `estimate(node)` is a lower
/// bound of the cost from there to the goal, and consistent: along no edge does it fall by more than the edge's length.
/// Settles nodes by cost + estimate, stops at the first with goal(node) and returns it; nullopt if there is none.
/// O((nodes + edges) log edges) for what is reached.
template <class Cost, class Neighbours, class Goal, class Estimate>
std::optional<std::size_t> a_star(SearchTree<Cost>& tree, std::size_t n, SearchSources<Cost> sources,
                                  Neighbours neighbours, Goal goal, Estimate estimate) {
  tree.begin(n);
  for (const auto& [node, cost] : sources)
    if (tree.improve(node, cost, SearchTree<Cost>::kSource)) tree.push(cost + estimate(node), node);
  while (const std::optional<std::size_t> at = tree.settle_next()) {
    if (goal(*at)) return at;
    const Cost so_far = tree.cost(*at);
    neighbours(*at, [&](std::size_t next, Cost length) {
      const Cost cost = so_far + length;
      if (!tree.improve(next, cost, static_cast<std::uint32_t>(*at))) return false;
      tree.push(cost + estimate(next), next);
      return true;
    });
  }
  return std::nullopt;
}
template <class Cost, class Neighbours, class Goal, class Estimate>
std::optional<std::size_t> a_star(SearchTree<Cost>& tree, std::size_t n, std::size_t source, Neighbours neighbours,
                                  Goal goal, Estimate estimate) {
  const std::pair<std::size_t, Cost> from(source, Cost{});
  return a_star(tree, n, SearchSources<Cost>(&from, 1), neighbours, goal, estimate);
}

/// Dijkstra's search: A* without an estimate, so goal(node) is asked in the order of nodes' costs.
template <class Cost, class Neighbours, class Goal>
std::optional<std::size_t> dijkstra(SearchTree<Cost>& tree, std::size_t n, SearchSources<Cost> sources,
                                    Neighbours neighbours, Goal goal) {
  return a_star(tree, n, sources, neighbours, goal, [](std::size_t) { return Cost{}; });
}
template <class Cost, class Neighbours, class Goal>
std::optional<std::size_t> dijkstra(SearchTree<Cost>& tree, std::size_t n, std::size_t source, Neighbours neighbours,
                                    Goal goal) {
  return a_star(tree, n, source, neighbours, goal, [](std::size_t) { return Cost{}; });
}
/// The same without a goal: settles all that can be reached.
template <class Cost, class Neighbours>
void dijkstra(SearchTree<Cost>& tree, std::size_t n, std::size_t source, Neighbours neighbours) {
  dijkstra(tree, n, source, neighbours, [](std::size_t) { return false; });
}

}  // namespace oxturn
