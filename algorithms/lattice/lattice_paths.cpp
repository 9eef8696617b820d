#include "algorithms/lattice/lattice_paths.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace oxturn {
namespace {

constexpr int kNear = 8;  // cells about a place in which a node is looked for

int nearest_int(double v) { return static_cast<int>(v + 1.5) - 1; }  // of -1.5 and more

/// No node that is not free lies on the straight way, or next to it: a cheap guess, before walls are asked.
bool seems_free(const GridGraph& graph, const Point& a, const Point& b) {
  const Point p = graph.coordinates(a), d = graph.coordinates(b) - p;
  const int steps = 2 * static_cast<int>(std::ceil(d.cwiseAbs().maxCoeff() - 1e-9));
  for (int s = 1; s < steps; ++s) {
    const Point at = p + d * (static_cast<double>(s) / steps);
    if (!graph.free(nearest_int(at.x()), nearest_int(at.y()))) return false;
  }
  return true;
}

/// Corners left out wherever the straight way is free. Exactly; but only where the lattice says it may be.
Polyline pulled(const Polyline& way, const GridGraph& graph, const EdgeIndex& walls) {
  Polyline straight{way.front()};
  for (std::size_t k = 0; k + 1 < way.size();) {
    std::size_t next = k + 1;
    while (next + 1 < way.size() && seems_free(graph, way[k], way[next + 1])) ++next;
    while (next > k + 1 && !walls.contains(way[k], way[next])) --next;
    straight.push_back(way[next]);
    k = next;
  }
  return straight;
}

}  // namespace

LatticePaths::LatticePaths(const GridGraph& graph, const EdgeIndex& walls)
    : graph_(graph),
      walls_(walls),
      columns_(static_cast<std::uint32_t>(graph.columns())),
      step_{1, graph.columns(), -1, -graph.columns()},
      state_(graph.size(), kUnseen << 4),
      part_(graph.size(), -1) {
  for (int j = 0; j < graph.rows(); ++j)
    for (int i = 0; i < graph.columns(); ++i)
      for (const Direction d : kAllDirections)
        if (graph.passable(i, j, d)) state_[graph.at(i, j)] |= static_cast<std::uint8_t>(1 << d);
  std::vector<std::uint32_t> queue;
  std::int32_t parts = 0;
  for (std::size_t c = 0; c < graph_.size(); ++c) {
    if (part_[c] >= 0 || !graph_.free(column(c), row(c))) continue;
    queue.assign(1, static_cast<std::uint32_t>(c));
    part_[c] = parts;
    while (!queue.empty()) {
      const std::size_t at = queue.back();
      queue.pop_back();
      for (const Direction d : kAllDirections) {
        if (!open(at, d)) continue;
        const std::size_t to = neighbour(at, d);
        if (part_[to] >= 0) continue;
        part_[to] = parts;
        queue.push_back(static_cast<std::uint32_t>(to));
      }
    }
    ++parts;
  }
}

std::optional<std::size_t> LatticePaths::node_near(const Point& p) const {
  const Point at = graph_.coordinates(p);
  const int ci = static_cast<int>(std::lround(at.x())), cj = static_cast<int>(std::lround(at.y()));
  std::optional<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (int j = cj - kNear; j <= cj + kNear; ++j)
    for (int i = ci - kNear; i <= ci + kNear; ++i) {
      if (!graph_.free(i, j)) continue;
      const double off = std::hypot(i - at.x(), j - at.y());
      if (off >= least || !walls_.contains(p, graph_.centre(i, j))) continue;
      least = off;
      best = graph_.at(i, j);
    }
  return best;
}

void LatticePaths::forget() {
  for (const std::uint32_t node : seen_) note(node, kUnseen);
  seen_.clear();
}

Polyline LatticePaths::along(const std::vector<std::size_t>& nodes) const {
  Polyline way;
  for (std::size_t k = 0; k < nodes.size(); ++k)  // numbers step by a constant along a straight run
    if (k == 0 || k + 1 == nodes.size() || nodes[k + 1] - nodes[k] != nodes[k] - nodes[k - 1])
      way.push_back(place(nodes[k]));
  return pulled(way, graph_, walls_);
}

// Weighted A*: what has been driven counts kDriven a step, what is left, as the crow walks, kLeft. A step towards the goal
// lowers that sum by one, one away raises it by seventeen; among equals the last comes first.
Polyline LatticePaths::way(std::size_t from, std::size_t to) {
  if (part_[from] < 0 || part_[from] != part_[to]) return {};
  const int i2 = column(to), j2 = row(to);
  // By the sum, less what it is at least: kDriven times the straight steps.
  std::size_t level =
      static_cast<std::size_t>(std::abs(column(from) - i2) + std::abs(row(from) - j2)) * (kLeft - kDriven);
  std::size_t highest = level;
  const auto push = [&](std::size_t node, std::uint8_t came, std::size_t sum) {
    if (waiting_.size() <= sum) waiting_.resize(sum + 1);
    highest = std::max(highest, sum);
    waiting_[sum].push_back({static_cast<std::uint32_t>(node), came});
  };
  push(from, kRoot, level);
  for (;;) {
    while (waiting_[level].empty()) ++level;
    const Step step = waiting_[level].back();
    waiting_[level].pop_back();
    const std::size_t at = step.node;
    if (came(at) != kUnseen) continue;
    see(at, step.came);
    if (at == to) break;
    const int i = column(at), j = row(at);
    const std::array<bool, 4> nearer{i<i2, j<j2, i> i2, j> j2};
    bool any_nearer = false;
    for (const Direction d : kAllDirections) {
      if (!open(at, d)) continue;
      const std::size_t next = neighbour(at, d);
      if (came(next) != kUnseen) continue;
      const bool towards = nearer[static_cast<std::size_t>(d)];
      any_nearer = any_nearer || towards;
      push(next, static_cast<std::uint8_t>(d), towards ? level + kDriven - kLeft : level + kDriven + kLeft);
    }
    if (any_nearer) --level;
  }
  for (; level <= highest; ++level) waiting_[level].clear();
  Polyline found = traced_back(to);
  forget();
  return found;
}

// Breadth first.
std::optional<LatticePaths::Found> LatticePaths::nearest(std::size_t from,
                                                       const std::function<bool(std::size_t)>& wanted) {
  std::optional<Found> found;
  see(from, kRoot);
  for (std::size_t k = 0; k < seen_.size(); ++k) {
    const std::size_t at = seen_[k];
    if (wanted(at)) {
      found = Found{at, traced_back(at)};
      break;
    }
    for (const Direction d : kAllDirections)
      if (open(at, d) && came(neighbour(at, d)) == kUnseen) see(neighbour(at, d), static_cast<std::uint8_t>(d));
  }
  forget();
  return found;
}

std::optional<LatticePaths::Found> LatticePaths::nearest(const Point& from,
                                                       const std::function<bool(std::size_t)>& wanted) {
  const auto node = node_near(from);
  if (!node) return std::nullopt;
  auto found = nearest(*node, wanted);
  if (found && found->way.front() != from) found->way.insert(found->way.begin(), from);
  return found;
}

}  // namespace oxturn
