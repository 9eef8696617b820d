/// In which order a robot visits the connected components of the free coarse cells: the first from its start, the
/// others as branches of it.
///
///   ComponentOrder order(problem, fine, cells, components_of(cells), paths);
///   const auto root = order.first();                // nullopt: there is none
///   for (const auto& branch : order.branches()) ...  // the others, parents first
///
/// Components that the lattice of sub-cells connects become one tree, each by a path from the nearest sub-cell of a
/// component that is in the tree already: a minimum spanning tree by steps over the lattice (Prim 1957). These trees in
/// turn are connected by a minimum spanning tree of shortest paths among the walls (component_links.hpp). Both are
/// minimum spanning trees, so the whole is one, as far as steps over the lattice measure length.
/// O(n log n) for n sub-cells, and a short shortest path for each tree.
#pragma once

#include <optional>
#include <vector>

#include "algorithms/lattice/lattice_paths.hpp"
#include "algorithms/lattice/spanning_trees.hpp"
#include "algorithms/transit/component_links.hpp"

namespace oxturn {

class ComponentOrder {
 public:
  /// All must outlive it.
  ComponentOrder(const Problem& problem, const GridGraph& fine, const CoarseCells& cells,
                 const ConnectedComponents& components, LatticePaths& paths);
  /// How a component is entered.
  struct Entry {
    Cell at;               // sub-cell
    std::size_t coarse;    // its coarse cell
    Polyline path;         // to the sub-cell
    std::size_t from = 0;  // of a branch: the sub-cell, by number, where the path begins
  };
  /// The component under the start if it can be reached straight, else the nearest. nullopt if there is none.
  std::optional<Entry> first();
  /// All others that can be reached, each after the one that it branches off from.
  std::vector<Entry> branches();

 private:
  class Prim;
  std::optional<Entry> under(const Point& p) const;
  std::optional<Entry> over_lattice(const Point& p);
  std::optional<Entry> among_walls(const Point& p) const;
  std::vector<ComponentLinks::Link> links_among_walls() const;
  template <class F>
  void for_each_boundary_sub_cell(F f) const;
  void enter(const Entry& entry);
  Entry entry_at(std::size_t node, Polyline path, std::size_t from = 0) const;
  std::size_t sub_cell(std::size_t cell, int k = 0) const {
    return fine_.at(2 * cells_.column(cell) + k % 2, 2 * cells_.row(cell) + k / 2);
  }
  std::size_t coarse(std::size_t node) const { return cells_.at(fine_.column(node) / 2, fine_.row(node) / 2); }
  /// The node lies in a component that has not been entered.
  bool left(std::size_t node) const {
    const int component = components_.of[coarse(node)];
    return component >= 0 && !done_[static_cast<std::size_t>(component)];
  }

  const Problem& problem_;
  const GridGraph& fine_;
  const CoarseCells& cells_;
  const ConnectedComponents& components_;
  LatticePaths& paths_;
  std::vector<bool> done_;  // components entered
  std::vector<int> left_;   // how many are left, by component of the lattice
  std::size_t at_ = 0;      // the last entry's sub-cell
};

}  // namespace oxturn
