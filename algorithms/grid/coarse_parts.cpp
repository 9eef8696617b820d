#include "algorithms/grid/coarse_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

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
  std::vector<bool> seen(cells.size(), false);
  std::vector<Step> stack{{root, order_from(kEast), 0}};
  seen[root] = true;
  while (!stack.empty()) {
    Step& top = stack.back();
    if (top.next == 4) {
      stack.pop_back();
      continue;
    }
    const Direction d = top.order[static_cast<std::size_t>(top.next++)];
    if (!cells.adjacent(top.cell, d)) continue;
    const std::size_t to = cells.neighbour(top.cell, d);
    if (seen[to]) continue;
    seen[to] = true;
    cells.link(top.cell, d);
    stack.push_back({to, order_from(d), 0});
  }
}

// Kruskal over the part with two weights: all horizontal edges first, then vertical ones.
void grow_weighted(CoarseCells& cells, const std::vector<int>& part, int which) {
  std::vector<std::uint32_t> parent(cells.size());
  std::iota(parent.begin(), parent.end(), 0u);
  const auto find = [&](std::size_t c) {
    while (parent[c] != c) c = parent[c] = parent[parent[c]];
    return c;
  };
  for (const Direction d : {kEast, kNorth})
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (part[c] != which || !cells.adjacent(c, d)) continue;
      const std::size_t a = find(c), b = find(cells.neighbour(c, d));
      if (a == b) continue;
      parent[b] = static_cast<std::uint32_t>(a);
      cells.link(c, d);
    }
}

}  // namespace

void grow_tree(CoarseCells& cells, std::size_t root, const CoarseParts& parts, const std::string& kind, Rng& rng) {
  if (kind == "bfs")
    grow_breadth_first(cells, root);
  else if (kind == "weighted")
    grow_weighted(cells, parts.of, parts.of[root]);
  else
    grow_depth_first(cells, root, kind == "minimum-turn", kind == "random" ? &rng : nullptr);
}

namespace {

Point sub_cell(const GridGraph& fine, const CoarseCells& cells, std::size_t c, int k) {
  return fine.centre(2 * cells.column(c) + k % 2, 2 * cells.row(c) + k / 2);
}

// Only cells at the edge of their part can be where a way from another part first comes in.
bool on_rim(const CoarseCells& cells, std::size_t c) {
  return std::any_of(kAllDirections.begin(), kAllDirections.end(), [&](Direction d) { return !cells.adjacent(c, d); });
}

}  // namespace

PartsInOrder::PartsInOrder(const Problem& problem, const GridGraph& fine, const CoarseCells& cells,
                           const CoarseParts& parts)
    : problem_(problem), fine_(fine), cells_(cells), parts_(parts), nearest_(problem) {
  for (std::size_t c = 0; c < cells.size(); ++c)
    if (parts.of[c] >= 0 && on_rim(cells, c))
      for (int k = 0; k < 4; ++k)
        nearest_.add(sub_cell(fine, cells, c, k), parts.of[c], c * 4 + static_cast<std::size_t>(k));
}

std::optional<NearestPart::Found> PartsInOrder::under(const Point& p) const {
  const Point at = fine_.coordinates(p);
  const int i = static_cast<int>(std::lround(at.x())), j = static_cast<int>(std::lround(at.y()));
  if (!fine_.inside(i, j)) return std::nullopt;
  const std::size_t c = cells_.at(i / 2, j / 2);
  const int k = i % 2 + 2 * (j % 2);
  if (parts_.of[c] < 0) return std::nullopt;
  auto way = problem_.transit().path(p, sub_cell(fine_, cells_, c, k));
  if (!way) return std::nullopt;
  return NearestPart::Found{c * 4 + static_cast<std::size_t>(k), std::move(*way)};
}

std::optional<PartsInOrder::Entry> PartsInOrder::next(const Point& from, bool first) {
  std::optional<NearestPart::Found> found;
  if (first) found = under(from);
  if (!found) found = nearest_.from(from);
  if (!found) return std::nullopt;
  const std::size_t c = found->id / 4;
  const int k = static_cast<int>(found->id % 4);
  nearest_.drop(parts_.of[c]);
  return Entry{2 * cells_.column(c) + k % 2, 2 * cells_.row(c) + k / 2, c, std::move(found->way)};
}

}  // namespace oxturn
