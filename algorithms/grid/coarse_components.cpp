#include "algorithms/grid/coarse_components.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace oxturn {

CoarseParts parts_of(const CoarseCells& cells) {
  CoarseParts parts{std::vector<int>(cells.size(), -1), 0};
  std::vector<std::size_t> queue;
  for (std::size_t c = 0; c < cells.size(); ++c) {
    if (!cells.free(c) || parts.of[c] >= 0) continue;
    parts.of[c] = parts.count;
    queue.assign(1, c);
    for (std::size_t k = 0; k < queue.size(); ++k)
      for (const Direction d : kAllDirections)
        if (cells.adjacent(queue[k], d) && parts.of[cells.neighbour(queue[k], d)] < 0) {
          parts.of[cells.neighbour(queue[k], d)] = parts.count;
          queue.push_back(cells.neighbour(queue[k], d));
        }
    ++parts.count;
  }
  return parts;
}

std::array<Direction, 4> depth_first_order(Direction came, bool straight, Rng* shuffled) {
  std::array<Direction, 4> order = kAllDirections;
  if (straight) order = {came, left_of(came), right_of(came), opposite(came)};
  if (shuffled) shuffled->shuffle(order);
  return order;
}

namespace {

// Depth-first without recursion: a million cells are a deep tree. `straight`: go on as one came, if possible.
void grow_depth_first(CoarseCells& cells, std::size_t root, bool straight, Rng* shuffled) {
  struct Step {
    std::size_t cell;
    std::array<Direction, 4> order;
    int next;
  };
  const auto order_from = [&](Direction came) { return depth_first_order(came, straight, shuffled); };
  std::vector<Step> stack{{root, order_from(kEast), 0}};
  while (!stack.empty()) {
    Step& top = stack.back();
    if (top.next == 4) {
      stack.pop_back();
      continue;
    }
    const Direction d = top.order[static_cast<std::size_t>(top.next++)];
    if (!cells.adjacent(top.cell, d)) continue;
    const std::size_t to = cells.neighbour(top.cell, d);
    if (to == root || cells.linked(to)) continue;
    cells.link(top.cell, d);
    stack.push_back({to, order_from(d), 0});
  }
}

}  // namespace

TreeGrower::TreeGrower(CoarseCells& cells, const std::string& kind, Rng& rng)
    : cells_(cells), kind_(kind), rng_(rng), parent_(kind == "weighted" ? cells.size() : 0, kAlone) {}

void TreeGrower::grow(std::size_t root) {
  if (kind_ == "bfs")
    grow_breadth_first(cells_, root);
  else if (kind_ == "weighted")
    grow_weighted(root);
  else
    grow_depth_first(cells_, root, kind_ == "minimum-turn", kind_ == "random" ? &rng_ : nullptr);
}

// Kruskal over the part with two weights: all horizontal edges first, then vertical ones.
void TreeGrower::grow_weighted(std::size_t root) {
  std::vector<std::uint32_t> part;
  const auto take = [&](std::size_t c) {
    if (parent_[c] != kAlone) return;
    part.push_back(parent_[c] = static_cast<std::uint32_t>(c));
  };
  take(root);
  for (std::size_t k = 0; k < part.size(); ++k)
    for (const Direction d : kAllDirections)
      if (cells_.adjacent(part[k], d)) take(cells_.neighbour(part[k], d));
  std::sort(part.begin(), part.end());
  const auto find = [&](std::size_t c) {
    while (parent_[c] != c) c = parent_[c] = parent_[parent_[c]];
    return static_cast<std::uint32_t>(c);
  };
  for (const Direction d : {kEast, kNorth})
    for (const std::uint32_t c : part) {
      if (!cells_.adjacent(c, d)) continue;
      const std::uint32_t a = find(c), b = find(cells_.neighbour(c, d));
      if (a == b) continue;
      parent_[b] = a;
      cells_.link(c, d);
    }
}

}  // namespace oxturn
