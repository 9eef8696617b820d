#include "base/graph_search.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "base/random.hpp"

namespace oxturn {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

struct Edge {
  std::size_t to;
  double length;
};
using Graph = std::vector<std::vector<Edge>>;

/// Undirected, whole lengths from 0 to 4: many equal costs, and exact sums.
Graph random_graph(std::uint64_t seed) {
  Rng rng(seed);
  Graph graph(2 + rng.below(20));
  const std::size_t edges = rng.below(2 * graph.size());
  for (std::size_t k = 0; k < edges; ++k) {
    const std::size_t a = rng.below(graph.size()), b = rng.below(graph.size());
    const auto length = static_cast<double>(rng.below(5));
    graph[a].push_back({b, length});
    graph[b].push_back({a, length});
  }
  return graph;
}

/// Oracle: Floyd and Warshall's distances of all pairs.
std::vector<std::vector<double>> all_distances(const Graph& graph, bool count_edges = false) {
  const std::size_t n = graph.size();
  std::vector<std::vector<double>> d(n, std::vector<double>(n, kInf));
  for (std::size_t i = 0; i < n; ++i) {
    d[i][i] = 0;
    for (const Edge& e : graph[i])
      if (e.to != i) d[i][e.to] = std::min(d[i][e.to], count_edges ? 1 : e.length);
  }
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) d[i][j] = std::min(d[i][j], d[i][k] + d[k][j]);
  return d;
}

auto neighbours_in(const Graph& graph) {
  return [&graph](std::size_t at, auto reach) {
    for (const Edge& e : graph[at]) reach(e.to, e.length);
  };
}

double length_of(const Graph& graph, const std::vector<std::size_t>& path) {
  double sum = 0;
  for (std::size_t k = 1; k < path.size(); ++k) {
    double least = kInf;
    for (const Edge& e : graph[path[k - 1]])
      if (e.to == path[k]) least = std::min(least, e.length);
    sum += least;
  }
  return sum;
}

TEST(BreadthFirst, ReachesNodesInTheOrderOfTheirDistance) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Graph graph = random_graph(seed);
    const auto distance = all_distances(graph, true);
    std::vector<bool> marked(graph.size(), false);
    std::vector<std::size_t> reached{0};
    marked[0] = true;
    breadth_first(reached, [&](std::size_t at, auto reach) {
      for (const Edge& e : graph[at]) {
        if (marked[e.to]) continue;
        marked[e.to] = true;
        reach(e.to);
      }
    });
    std::size_t connected = 0;
    for (const double d : distance[0]) connected += d < kInf ? 1 : 0;
    ASSERT_EQ(reached.size(), connected);
    for (std::size_t k = 1; k < reached.size(); ++k) EXPECT_LE(distance[0][reached[k - 1]], distance[0][reached[k]]);
  }
}

TEST(BreadthFirst, StopsAtTheFirstGoal) {
  std::vector<int> reached{0};  // 0 -> 1, 2; 1 -> 3, 4; 2 -> 5, 6; ...
  const auto expand = [](int at, auto reach) {
    reach(2 * at + 1);
    reach(2 * at + 2);
  };
  const auto found = breadth_first(reached, expand, [](int at) { return at >= 5; });
  ASSERT_TRUE(found);
  EXPECT_EQ(reached[*found], 5);
  std::vector<int> nothing;
  EXPECT_FALSE(breadth_first(nothing, expand, [](int) { return true; }));
}

TEST(Dijkstra, CostsAreTheDistances) {
  SearchTree<double> tree;  // one for all searches: what they leave behind does no harm
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Graph graph = random_graph(seed);
    const auto distance = all_distances(graph);
    dijkstra(tree, graph.size(), 0, neighbours_in(graph));
    for (std::size_t i = 0; i < graph.size(); ++i) {
      ASSERT_EQ(tree.settled(i), distance[0][i] < kInf);
      if (!tree.reached(i)) continue;
      EXPECT_EQ(tree.cost(i), distance[0][i]);
      const std::vector<std::size_t> path = tree.path_to(i);
      EXPECT_EQ(path.front(), 0u);
      EXPECT_EQ(length_of(graph, path), distance[0][i]);
    }
    EXPECT_FALSE(tree.reached(graph.size() + 100));
  }
}

TEST(Dijkstra, SettlesByCostThenByNumber) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    const Graph graph = random_graph(seed);
    SearchTree<double> tree;
    std::pair<double, std::size_t> last{-1, 0};
    bool zero_length = false;
    for (const auto& edges : graph)
      for (const Edge& e : edges) zero_length = zero_length || e.length == 0;
    dijkstra(tree, graph.size(), 0, neighbours_in(graph), [&](std::size_t at) {
      const std::pair next(tree.cost(at), at);
      // An edge without length may open a lower number at the same cost later.
      EXPECT_TRUE(zero_length ? last.first <= next.first : last < next);
      last = next;
      return false;
    });
  }
}

TEST(Dijkstra, FromSeveralSourcesTheNearestCounts) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    const Graph graph = random_graph(seed);
    const auto distance = all_distances(graph);
    const std::vector<std::pair<std::size_t, double>> sources{{0, 2.0}, {1, 0.5}};
    SearchTree<double> tree;
    dijkstra(tree, graph.size(), sources, neighbours_in(graph), [](std::size_t) { return false; });
    for (std::size_t i = 0; i < graph.size(); ++i) {
      const double least = std::min(2.0 + distance[0][i], 0.5 + distance[1][i]);
      ASSERT_EQ(tree.reached(i), least < kInf);
      if (least < kInf) { EXPECT_EQ(tree.cost(i), least); }
    }
  }
}

TEST(AStar, FindsWhatDijkstraFindsAndSettlesNoMore) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    const Graph graph = random_graph(seed);
    const auto distance = all_distances(graph);
    const std::size_t goal = graph.size() - 1;
    const auto settled = [&](double share) {  // a share of the true distance is a consistent estimate
      SearchTree<double> tree;
      const auto found = a_star(
          tree, graph.size(), std::size_t{0}, neighbours_in(graph), [&](std::size_t at) { return at == goal; },
          [&](std::size_t at) { return distance[at][goal] < kInf ? share * distance[at][goal] : 0; });
      EXPECT_EQ(found.has_value(), distance[0][goal] < kInf);
      if (found) {
        EXPECT_EQ(*found, goal);
        EXPECT_EQ(tree.cost(goal), distance[0][goal]);
        EXPECT_EQ(length_of(graph, tree.path_to(goal)), distance[0][goal]);
      }
      std::size_t count = 0;
      for (std::size_t i = 0; i < graph.size(); ++i)
        if (tree.settled(i) && tree.cost(i) + distance[i][goal] > distance[0][goal]) ++count;
      return count;  // nodes off all shortest paths
    };
    EXPECT_LE(settled(0.5), settled(0));
    EXPECT_EQ(settled(1), distance[0][goal] < kInf ? 0 : settled(0));
  }
}

TEST(AStar, OfEqualPathsTheFirstFoundIsKept) {
  const Graph graph{{{2, 1}, {1, 1}}, {{3, 1}}, {{3, 1}}, {}};  // 0 -> 1 -> 3 and 0 -> 2 -> 3
  SearchTree<int> tree;
  const auto neighbours = [&](std::size_t at, auto reach) {
    for (const Edge& e : graph[at]) reach(e.to, static_cast<int>(e.length));
  };
  dijkstra(tree, graph.size(), 0, neighbours);
  EXPECT_EQ(tree.path_to(3), (std::vector<std::size_t>{0, 1, 3}));  // 1 is settled before 2
}

TEST(ConnectedComponents, AreTheNodesAtFiniteDistance) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    Graph graph = random_graph(seed);
    const auto contains = [](std::size_t i) { return i % 5 != 4; };
    const auto components = connected_components(graph.size(), contains, [&](std::size_t at, auto reach) {
      for (const Edge& e : graph[at]) reach(e.to);
    });
    Graph rest(graph.size());
    for (std::size_t i = 0; i < graph.size(); ++i)
      for (const Edge& e : graph[i])
        if (contains(i) && contains(e.to)) rest[i].push_back(e);
    const auto distance = all_distances(rest);
    std::int32_t next = 0;
    for (std::size_t i = 0; i < graph.size(); ++i) {
      ASSERT_EQ(components.of[i] == ConnectedComponents::kNone, !contains(i));
      if (!contains(i)) continue;
      ASSERT_LE(components.of[i], next);  // numbered by their lowest nodes
      next = std::max(next, components.of[i] + 1);
      for (std::size_t j = 0; j < i; ++j)
        if (contains(j)) { EXPECT_EQ(components.of[i] == components.of[j], distance[i][j] < kInf); }
    }
    EXPECT_EQ(components.count, next);
  }
}

}  // namespace
}  // namespace oxturn
