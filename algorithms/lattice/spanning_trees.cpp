#include "algorithms/lattice/spanning_trees.hpp"

#include <algorithm>

namespace oxturn {

ConnectedComponents components_of(const CoarseCells& cells) {
  return connected_components(
      cells.size(), [&](std::size_t c) { return cells.free(c); },
      [&](std::size_t c, const auto& reach) {
        for (const Direction d : kAllDirections)
          if (cells.adjacent(c, d)) reach(cells.neighbour(c, d));
      });
}

TreeGrower::TreeGrower(CoarseCells& cells, TreeKind kind, Rng& rng)
    : cells_(cells),
      kind_(kind),
      rng_(rng),
      joined_(kind == TreeKind::weighted ? cells.size() : 0),
      taken_(joined_.size(), false) {}

void TreeGrower::grow(std::size_t root) {
  if (kind_ == TreeKind::bfs) {
    grow_breadth_first(cells_, root);
  } else if (kind_ == TreeKind::weighted) {
    grow_weighted(root);
  } else {
    grow_depth_first(root, kind_, rng_, 1, [&](std::size_t cell, Direction d, int) -> std::optional<std::size_t> {
      if (!cells_.adjacent(cell, d)) return std::nullopt;
      const std::size_t to = cells_.neighbour(cell, d);
      if (to == root || cells_.linked(to)) return std::nullopt;
      cells_.link(cell, d);
      return to;
    });
  }
}

// Kruskal's algorithm with two weights: all horizontal edges first, then the vertical ones.
void TreeGrower::grow_weighted(std::size_t root) {
  if (taken_[root]) return;
  std::vector<std::size_t> component{root};
  taken_[root] = true;
  breadth_first(component, [&](std::size_t c, const auto& reach) {
    for (const Direction d : kAllDirections) {
      if (!cells_.adjacent(c, d) || taken_[cells_.neighbour(c, d)]) continue;
      taken_[cells_.neighbour(c, d)] = true;
      reach(cells_.neighbour(c, d));
    }
  });
  std::sort(component.begin(), component.end());
  for (const Direction d : {kEast, kNorth})
    for (const std::size_t c : component)
      if (cells_.adjacent(c, d) && joined_.unite(c, cells_.neighbour(c, d))) cells_.link(c, d);
}

}  // namespace oxturn
