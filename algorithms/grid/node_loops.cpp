#include "algorithms/grid/node_loops.hpp"

#include <algorithm>
#include <cmath>

namespace oxturn {
namespace {

NodeLoop closed_loop(Polyline nodes) {
  nodes.push_back(nodes.front());
  NodeLoop loop{std::move(nodes), {}};
  loop.edges.resize(loop.at.size());
  for (std::size_t k = 0; k + 1 < loop.at.size(); ++k) {
    (k == 0 ? loop.edges[k].first : loop.edges[k].second) = k + 1;
    loop.edges[k + 1].first = k;
  }
  return loop;
}

}  // namespace

std::vector<NodeLoop> node_loops(const std::vector<Point>& vertices, double d_node) {
  Polyline nodes;
  const std::size_t n = vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point &a = vertices[i], &b = vertices[(i + 1) % n];
    const double dist = distance(a, b);
    if (!(dist > 0)) continue;
    nodes.push_back(a);
    const double count = std::max(0.0, std::ceil(dist / d_node - 1));
    const double gap = dist / (count + 1);
    for (double k = 1; k <= count; ++k) nodes.push_back(a + (b - a) * (gap / dist * k));
  }
  std::vector<NodeLoop> loops;
  Polyline loop;
  for (const Point& p : nodes) {
    if (!loop.empty() && p == loop.front()) {
      if (loop.size() > 1) loops.push_back(closed_loop(loop));
      loop.clear();
    }
    loop.push_back(p);
  }
  if (loop.size() > 1) loops.push_back(closed_loop(std::move(loop)));
  return loops;
}

std::vector<std::size_t> invalid_nodes(const NodeLoop& loop, std::size_t start,
                                       const std::function<bool(std::size_t)>& invalid) {
  std::vector<std::size_t> bad;
  std::size_t previous = NodeLoop::kNone, current = start, next = loop.edges[start].first;
  while (previous == NodeLoop::kNone || loop.at[current] != loop.at[start]) {
    if (invalid(current)) bad.push_back(current);
    previous = current;
    current = next;
    const auto [first, second] = loop.edges[current];
    next = first == previous && second != NodeLoop::kNone ? second : first;
  }
  if (invalid(current)) bad.push_back(current);
  return bad;
}

std::vector<NodeChain> chains_of(const NodeLoop& loop, const std::vector<std::size_t>& bad) {
  if (bad.empty()) return {{loop.at, true}};
  const std::size_t n = loop.at.size() - 1;  // without the duplicate
  std::vector<bool> gone(n, false);
  for (const std::size_t k : bad) gone[k % n] = true;  // the duplicate goes with its start
  const auto first_gone = static_cast<std::size_t>(std::find(gone.begin(), gone.end(), true) - gone.begin());
  std::vector<NodeChain> chains;
  bool in_chain = false;
  for (std::size_t step = 1; step < n; ++step) {  // once around, from the first gap on
    const std::size_t k = (first_gone + step) % n;
    if (gone[k]) {
      in_chain = false;
      continue;
    }
    if (!in_chain) chains.push_back({{}, false});
    in_chain = true;
    chains.back().nodes.push_back(loop.at[k]);
  }
  return chains;
}

}  // namespace oxturn
