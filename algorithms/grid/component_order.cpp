#include "algorithms/grid/component_order.hpp"

#include <algorithm>

#include "algorithms/transit/nearest_component.hpp"

namespace oxturn {

ComponentOrder::ComponentOrder(const Problem& problem, const GridGraph& fine, const CoarseCells& cells,
                               const ConnectedComponents& components, LatticePaths& paths)
    : problem_(problem),
      fine_(fine),
      cells_(cells),
      components_(components),
      paths_(paths),
      done_(static_cast<std::size_t>(components.count), false) {
  // The lattice connects a component's cells, so one of them stands for all.
  std::vector<bool> counted(done_.size(), false);
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (components.of[c] < 0 || counted[static_cast<std::size_t>(components.of[c])]) continue;
    counted[static_cast<std::size_t>(components.of[c])] = true;
    const auto whole = static_cast<std::size_t>(paths_.component(sub_cell(c)));
    if (left_.size() <= whole) left_.resize(whole + 1, 0);
    ++left_[whole];
  }
}

ComponentOrder::Entry ComponentOrder::entry_at(std::size_t node, Polyline path, std::size_t from) const {
  return {fine_.cell(node), coarse(node), std::move(path), from};
}

void ComponentOrder::enter(const Entry& entry) {
  at_ = fine_.at(entry.at);
  done_[static_cast<std::size_t>(components_.of[entry.coarse])] = true;
  --left_[static_cast<std::size_t>(paths_.component(at_))];
}

std::optional<ComponentOrder::Entry> ComponentOrder::first() {
  const Point& start = problem_.start();
  std::optional<Entry> entry = under(start);
  if (!entry) entry = over_lattice(start);
  if (!entry) entry = among_walls(start);
  if (entry) enter(*entry);
  return entry;
}

std::optional<ComponentOrder::Entry> ComponentOrder::under(const Point& p) const {
  const Cell at = fine_.cell_of(p);
  if (!fine_.inside(at.i, at.j) || !left(fine_.at(at))) return std::nullopt;
  if (!problem_.walls().contains(p, fine_.centre(at))) return std::nullopt;
  return entry_at(fine_.at(at), {p, fine_.centre(at)});
}

std::optional<ComponentOrder::Entry> ComponentOrder::over_lattice(const Point& p) {
  auto found = paths_.nearest(p, [this](std::size_t node) { return left(node); });
  if (!found) return std::nullopt;
  return entry_at(found->node, std::move(found->path));
}

// A path from another component enters one through a cell on its boundary.
template <class F>
void ComponentOrder::for_each_boundary_sub_cell(F f) const {
  for (std::size_t c = 0; c < cells_.size(); ++c) {
    if (components_.of[c] < 0) continue;
    const bool inner =
        std::all_of(kAllDirections.begin(), kAllDirections.end(), [&](Direction d) { return cells_.adjacent(c, d); });
    for (int k = 0; k < 4 && !inner; ++k) f(sub_cell(c, k));
  }
}

std::optional<ComponentOrder::Entry> ComponentOrder::among_walls(const Point& p) const {
  NearestComponent nearest(problem_);
  for_each_boundary_sub_cell([&](std::size_t node) { nearest.add(paths_.centre(node), 0, node); });
  auto found = nearest.from(p);
  if (!found) return std::nullopt;
  return entry_at(found->id, std::move(found->path));
}

/// Between the trees that the lattice connects.
std::vector<ComponentLinks::Link> ComponentOrder::links_among_walls() const {
  ComponentLinks links(problem_);
  for_each_boundary_sub_cell([&](std::size_t node) { links.add(paths_.centre(node), paths_.component(node), node); });
  return links.tree(paths_.component(at_));
}

/// Prim's algorithm. All sub-cells of components in the tree are sources of one wave; when it meets another component,
/// that component's sub-cells become sources as well. base/graph_search.hpp has no sources that are added on the way;
/// and since all steps cost one, a stack for each number of steps does in place of a heap.
class ComponentOrder::Prim {
 public:
  explicit Prim(ComponentOrder& order)
      : order_(order),
        steps_(order.fine_.size(), kFar),
        entered_(order.fine_.size(), LatticePaths::kSource),
        waiting_(1) {}

  /// Appends the components that the lattice connects to the last one entered.
  void append_tree(std::vector<Entry>& branches) {
    const auto whole = static_cast<std::size_t>(order_.paths_.component(order_.at_));
    if (order_.left_[whole] == 0) return;
    waiting_.resize(1);
    waiting_[0].clear();
    add_sources(order_.coarse(order_.at_));
    for (std::size_t steps = 0; steps < waiting_.size() && order_.left_[whole] > 0;) {
      if (waiting_[steps].empty()) {
        ++steps;
        continue;
      }
      const std::size_t at = waiting_[steps].back();
      waiting_[steps].pop_back();
      if (steps_[at] == steps && expand(at, branches)) steps = 0;
    }
  }

 private:
  static constexpr std::uint32_t kFar = std::numeric_limits<std::uint32_t>::max();

  void add_source(std::size_t cell) {
    for (int k = 0; k < 4; ++k) {
      const std::size_t node = order_.sub_cell(cell, k);
      steps_[node] = 0;
      entered_[node] = LatticePaths::kSource;
      waiting_[0].push_back(static_cast<std::uint32_t>(node));
    }
  }
  /// All cells of the component that contains `cell`.
  void add_sources(std::size_t cell) {
    component_.assign(1, cell);
    add_source(cell);
    breadth_first(component_, [this](std::size_t at, const auto& reach) {
      for (const Direction d : kAllDirections) {
        if (!order_.cells_.adjacent(at, d)) continue;
        const std::size_t next = order_.cells_.neighbour(at, d);
        if (steps_[order_.sub_cell(next)] == 0) continue;
        reach(next);
        add_source(next);
      }
    });
  }
  /// Returns whether new sources were added.
  bool expand(std::size_t at, std::vector<Entry>& branches) {
    const std::uint32_t next_steps = steps_[at] + 1;
    bool met = false;
    for (const Direction d : kAllDirections) {
      if (!order_.paths_.open(at, d)) continue;
      const std::size_t to = order_.paths_.neighbour(at, d);
      if (order_.left(to)) {
        branches.push_back(enter(at, to));
        met = true;
      } else if (steps_[to] > next_steps) {
        steps_[to] = next_steps;
        entered_[to] = static_cast<std::uint8_t>(d);
        if (waiting_.size() < next_steps + 1) waiting_.emplace_back();
        waiting_[next_steps].push_back(static_cast<std::uint32_t>(to));
      }
    }
    return met;
  }
  Entry enter(std::size_t at, std::size_t to) {
    std::vector<std::size_t> nodes = order_.paths_.nodes_to(at, [this](std::size_t node) { return entered_[node]; });
    nodes.push_back(to);
    Entry entry = order_.entry_at(to, order_.paths_.along(nodes), nodes.front());
    order_.enter(entry);
    add_sources(order_.coarse(to));
    return entry;
  }

  ComponentOrder& order_;
  std::vector<std::uint32_t> steps_;   // from the nearest source
  std::vector<std::uint8_t> entered_;  // how the wave entered a node (LatticePaths::nodes_to)
  std::vector<std::vector<std::uint32_t>> waiting_;
  std::vector<std::size_t> component_;
};

std::vector<ComponentOrder::Entry> ComponentOrder::branches() {
  std::vector<Entry> all;
  Prim prim(*this);
  prim.append_tree(all);
  if (std::all_of(done_.begin(), done_.end(), [](bool done) { return done; })) return all;
  for (ComponentLinks::Link& link : links_among_walls()) {
    all.push_back(entry_at(link.to, std::move(link.path), link.from));
    enter(all.back());
    prim.append_tree(all);
  }
  return all;
}

}  // namespace oxturn
