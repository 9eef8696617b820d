#include "algorithms/grid/partial_stc.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "algorithms/lattice/cell_robot.hpp"
#include "algorithms/grid/coarse_components.hpp"
#include "algorithms/transit/nearest_component.hpp"
#include "algorithms/grid/sub_cell_tree.hpp"

namespace oxturn {
namespace {

struct Ways {
  const GridGraph* fine;
  bool operator()(const Cell& c, Direction d) const { return fine->passable(c.i, c.j, d); }
};
using Tree = SubCellTree<Ways>;

// The two sub-cells on a side of the coarse cell, counter-clockwise.
std::array<Cell, 2> on_side(const Cell& base, Direction d) {
  Cell first = base;
  if (d == kEast || d == kNorth) first = neighbour(first, kEast);
  if (d == kNorth || d == kWest) first = neighbour(first, kNorth);
  return {first, neighbour(first, left_of(d))};
}

// Links what is new over side d of a coarse cell that is in the tree (of two nodes of one cell both may be): calls
// f(sub-cell beyond) for each.
template <class F>
void link_over(Tree& tree, const Cell& base, Direction d, F f) {
  for (const Cell& c : on_side(base, d))
    if (tree.holds(c) && tree.passable(c, d) && !tree.holds(neighbour(c, d))) {
      tree.link(c, d);
      f(neighbour(c, d));
    }
}

void grow_breadth_first(Tree& tree, const Cell& root) {
  std::vector<Cell> queue{tree.base(root)};
  for (std::size_t k = 0; k < queue.size(); ++k)
    for (const Direction d : kAllDirections) {
      const Cell base = queue[k];
      link_over(tree, base, d, [&](const Cell& c) { queue.push_back(tree.base(c)); });
    }
}

void grow_depth_first(Tree& tree, const Cell& root, bool straight, Rng* shuffled) {
  struct Visit {
    Cell base;
    std::array<Direction, 4> order;
    int next;
  };
  const auto order_from = [&](Direction came) { return depth_first_order(came, straight, shuffled); };
  std::vector<Visit> stack{{tree.base(root), order_from(kEast), 0}};
  while (!stack.empty()) {
    Visit& top = stack.back();
    if (top.next == 8) {
      stack.pop_back();
      continue;
    }
    const Direction d = top.order[static_cast<std::size_t>(top.next / 2)];
    const Cell c = on_side(top.base, d)[static_cast<std::size_t>(top.next++ % 2)];
    if (!tree.holds(c) || !tree.passable(c, d) || tree.holds(neighbour(c, d))) continue;
    tree.link(c, d);
    stack.push_back({tree.base(neighbour(c, d)), order_from(d), 0});
  }
}

// Kruskal with two weights: horizontal edges first.
void grow_weighted(Tree& tree, const GridGraph& fine, const std::vector<Cell>& cells,
                   std::vector<std::uint32_t>& parent) {
  const auto find = [&](const Cell& c) {
    auto k = static_cast<std::uint32_t>(fine.at(c.i, c.j));
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  };
  for (const Cell& c : cells)
    if (!tree.holds(c)) tree.add_node(c);
  for (const Cell& c : cells)
    for (const Direction d : {kEast, kNorth})
      if (tree.inner(c, d) && tree.open(c, d)) parent[find(c)] = find(neighbour(c, d));
  for (const Direction d : {kEast, kNorth})
    for (const Cell& c : cells) {
      if (tree.inner(c, d) || !tree.passable(c, d)) continue;
      const std::uint32_t a = find(c), b = find(neighbour(c, d));
      if (a == b) continue;
      parent[b] = a;
      tree.join(c, d);
    }
}

}  // namespace

Path go_round_partial(const Problem& problem, const GridGraph& fine, const std::string& kind, bool all,
                      Context& context) {
  std::vector<int> part(fine.size(), -1);
  std::vector<std::vector<Cell>> parts;
  for (int j = 0; j < fine.rows(); ++j)
    for (int i = 0; i < fine.columns(); ++i) {
      if (!fine.free(i, j) || part[fine.at(i, j)] >= 0) continue;
      const int number = static_cast<int>(parts.size());
      std::vector<Cell> cells{{i, j}};
      part[fine.at(i, j)] = number;
      for (std::size_t k = 0; k < cells.size(); ++k)
        for (const Direction d : kAllDirections) {
          const Cell c = neighbour(cells[k], d);
          if (!fine.passable(cells[k].i, cells[k].j, d) || part[fine.at(c.i, c.j)] >= 0) continue;
          part[fine.at(c.i, c.j)] = number;
          cells.push_back(c);
        }
      parts.push_back(std::move(cells));
    }
  std::optional<Entry> entry = entry_from_start(problem, fine);
  if (!entry) throw Infeasible("no sub-cell is free; a smaller cell_size may help");

  Tree tree(Ways{&fine}, {0, 0});
  std::vector<std::uint32_t> parent(kind == "weighted" ? fine.size() : 0);
  std::iota(parent.begin(), parent.end(), 0u);
  std::optional<NearestComponent> nearest;
  PathBuilder path(problem.start());
  for (std::size_t done = 0; entry && !context.cancelled();) {
    const Cell root{entry->column, entry->row};
    const int number = part[fine.at(root.i, root.j)];
    const std::vector<Cell>& cells = parts[static_cast<std::size_t>(number)];
    tree.add_node(root);
    if (kind == "bfs")
      grow_breadth_first(tree, root);
    else if (kind == "weighted")
      grow_weighted(tree, fine, cells, parent);
    else
      grow_depth_first(tree, root, kind == "minimum-turn", kind == "random" ? &context.rng() : nullptr);
    path.drive(entry->way, cells.size() == 1);  // a lone sub-cell is swept as it is come to
    Polyline round{fine.centre(root.i, root.j)};
    Cell at = root;
    std::optional<Direction> last;
    tree.round(
        root, [](const Cell&, Direction) { return false; },
        [&](Direction d) {
          at = neighbour(at, d);
          if (last == d)
            round.back() = fine.centre(at.i, at.j);
          else
            round.push_back(fine.centre(at.i, at.j));
          last = d;
          return true;
        });
    path.drive(round, true);
    context.progress(static_cast<double>(++done) / static_cast<double>(parts.size()));
    if (!all || done == parts.size()) break;
    if (!nearest) {
      nearest.emplace(problem);
      for (const std::vector<Cell>& other : parts)
        for (const Cell& c : other)
          if (std::any_of(kAllDirections.begin(), kAllDirections.end(),
                          [&](Direction d) { return !fine.passable(c.i, c.j, d); }))
            nearest->add(fine.centre(c.i, c.j), part[fine.at(c.i, c.j)], fine.at(c.i, c.j));
    }
    nearest->remove(number);
    const auto found = nearest->from(path.at());
    entry.reset();
    const auto columns = static_cast<std::size_t>(fine.columns());
    if (found) entry = Entry{static_cast<int>(found->id % columns), static_cast<int>(found->id / columns), found->path};
  }
  return path.take();
}

}  // namespace oxturn
