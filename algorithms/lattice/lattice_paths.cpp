#include "algorithms/lattice/lattice_paths.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr int kNear = 8;  // cells around a point in which node_near() looks
// Of weighted A*: the cost of a step driven, and the estimate for a step left.
constexpr std::size_t kDriven = 8, kLeft = 9;

int nearest_int(double v) { return static_cast<int>(v + 1.5) - 1; }  // for v >= -1.5

/// Only free nodes lie on the segment or next to it: a cheap guess, before the walls are asked.
bool seems_free(const GridGraph& graph, const Point& a, const Point& b) {
  const Point p = graph.coordinates(a), d = graph.coordinates(b) - p;
  const int steps = 2 * static_cast<int>(std::ceil(d.cwiseAbs().maxCoeff() - 1e-9));
  for (int s = 1; s < steps; ++s) {
    const Point at = p + d * (static_cast<double>(s) / steps);
    if (!graph.free(nearest_int(at.x()), nearest_int(at.y()))) return false;
  }
  return true;
}

/// Leaves out vertices wherever the shortcut lies in configuration space, exactly. Tries only what seems free.
Polyline pulled_straight(const Polyline& path, const GridGraph& graph, const EdgeIndex& walls) {
  Polyline straight{path.front()};
  for (std::size_t k = 0; k + 1 < path.size();) {
    std::size_t next = k + 1;
    while (next + 1 < path.size() && seems_free(graph, path[k], path[next + 1])) ++next;
    while (next > k + 1 && !walls.contains(path[k], path[next])) --next;
    straight.push_back(path[next]);
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
      states_(graph.size()),
      components_(components_of(graph)) {
  for (int j = 0; j < graph.rows(); ++j)
    for (int i = 0; i < graph.columns(); ++i)
      for (const Direction d : kAllDirections)
        if (graph.passable(i, j, d)) states_[graph.at(i, j)].open |= 1 << d;
}

std::optional<std::size_t> LatticePaths::node_near(const Point& p) const {
  const Point at = graph_.coordinates(p);
  const auto [ci, cj] = graph_.cell_of(p);
  std::optional<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (int j = cj - kNear; j <= cj + kNear; ++j)
    for (int i = ci - kNear; i <= ci + kNear; ++i) {
      if (!graph_.free(i, j)) continue;
      const double away = math::hypot(i - at.x(), j - at.y());
      if (away >= least || !walls_.contains(p, graph_.centre(i, j))) continue;
      least = away;
      best = graph_.at(i, j);
    }
  return best;
}

Polyline LatticePaths::along(const std::vector<std::size_t>& nodes) const {
  Polyline path;
  for (std::size_t k = 0; k < nodes.size(); ++k)  // node numbers change by a constant along a straight run
    if (k == 0 || k + 1 == nodes.size() || nodes[k + 1] - nodes[k] != nodes[k] - nodes[k - 1])
      path.push_back(centre(nodes[k]));
  return pulled_straight(path, graph_, walls_);
}

void LatticePaths::end_search() {
  for (const std::uint32_t node : seen_) states_[node].entered = kUnseen;
  seen_.clear();
}

// Weighted A*. Priorities are the cost so far plus the estimate, less kDriven times the steps of a straight line, so
// they are small numbers: a step towards the goal lowers them by one, one away raises them by seventeen. Hence one
// stack for each priority in place of the heap of base/graph_search.hpp; the last of equals comes first, which also
// goes straight on where it can.
Polyline LatticePaths::path(std::size_t from, std::size_t to) {
  if (component(from) < 0 || component(from) != component(to)) return {};
  const int i2 = column(to), j2 = row(to);
  std::size_t priority =
      static_cast<std::size_t>(std::abs(column(from) - i2) + std::abs(row(from) - j2)) * (kLeft - kDriven);
  std::size_t highest = priority;
  const auto push = [&](std::size_t node, std::uint8_t entered, std::size_t at) {
    if (waiting_.size() <= at) waiting_.resize(at + 1);
    highest = std::max(highest, at);
    waiting_[at].push_back({static_cast<std::uint32_t>(node), entered});
  };
  push(from, kSource, priority);
  for (;;) {
    while (waiting_[priority].empty()) ++priority;
    const Step step = waiting_[priority].back();
    waiting_[priority].pop_back();
    const std::size_t at = step.node;
    if (seen(at)) continue;
    enter(at, step.direction);
    if (at == to) break;
    const int i = column(at), j = row(at);
    const std::array<bool, 4> nearer{i<i2, j<j2, i> i2, j> j2};
    bool any_nearer = false;
    for (const Direction d : kAllDirections) {
      if (!open(at, d)) continue;
      const std::size_t next = neighbour(at, d);
      if (seen(next)) continue;
      const bool towards = nearer[static_cast<std::size_t>(d)];
      any_nearer = any_nearer || towards;
      push(next, static_cast<std::uint8_t>(d), towards ? priority + kDriven - kLeft : priority + kDriven + kLeft);
    }
    if (any_nearer) --priority;
  }
  for (; priority <= highest; ++priority) waiting_[priority].clear();
  Polyline found = path_to(to);
  end_search();
  return found;
}

std::optional<LatticePaths::Found> LatticePaths::nearest(std::size_t from,
                                                         const std::function<bool(std::size_t)>& wanted) {
  enter(from, kSource);
  const auto expand = [this](std::size_t at, const auto& reach) {
    for (const Direction d : kAllDirections) {
      if (!open(at, d)) continue;
      const std::size_t next = neighbour(at, d);
      if (seen(next)) continue;
      states_[next].entered = static_cast<std::uint8_t>(d);
      reach(static_cast<std::uint32_t>(next));
    }
  };
  const auto index = breadth_first(seen_, expand, [&](std::size_t node) { return wanted(node); });
  std::optional<Found> found;
  if (index) found = Found{seen_[*index], path_to(seen_[*index])};
  end_search();
  return found;
}

std::optional<LatticePaths::Found> LatticePaths::nearest(const Point& from,
                                                         const std::function<bool(std::size_t)>& wanted) {
  const auto node = node_near(from);
  if (!node) return std::nullopt;
  auto found = nearest(*node, wanted);
  if (found && found->path.front() != from) found->path.insert(found->path.begin(), from);
  return found;
}

}  // namespace oxturn
