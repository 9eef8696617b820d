// How a robot comes from part to part of the free coarse cells: the first from its start, the others as branches of it.
//
// Parts that hang together over the lattice of sub-cells become one tree, each by a way to the nearest sub-cell of a part
// that is in it already: a minimum spanning tree in steps over the lattice (Prim). Where no lattice leads on, the nearest
// part by shortest ways among the walls themselves is where the next tree begins.
//
// Complexity  a tree O(sub-cells); a question among walls as in nearest_part.hpp
#pragma once

#include <optional>
#include <vector>

#include "algorithms/grid/coarse_components.hpp"
#include "algorithms/lattice/lattice_paths.hpp"
#include "algorithms/transit/nearest_component.hpp"

namespace oxturn {

class PartOrder {
 public:
  /// All must outlive it.
  PartOrder(const Problem& problem, const GridGraph& fine, const CoarseCells& cells, const CoarseParts& parts,
            LatticePaths& ways);
  struct Entry {
    int i, j;            // sub-cell where the part is come to
    std::size_t coarse;  // cell
    Polyline way;        // to it
    std::size_t from;    // of a branch: the sub-cell, by number, where the way begins
  };
  /// The part under the start if it sees the sub-cell there, else the nearest to it. nullopt if none can be reached.
  std::optional<Entry> first();
  /// All parts that hang together over the lattice with the last one, the nearest to what is in the tree first.
  std::vector<Entry> branches();
  /// The nearest to `from` of those that are left.
  std::optional<Entry> next(const Point& from);

 private:
  std::optional<Entry> under(const Point& p) const;
  std::optional<Entry> over_lattice(const Point& p);
  std::optional<Entry> among_walls(const Point& p);
  std::optional<Entry> come_to(std::optional<Entry> entry);
  Entry entry_at(std::size_t node, Polyline way, std::size_t from = 0) const;
  int column(std::size_t node) const { return static_cast<int>(node % static_cast<std::size_t>(fine_.columns())); }
  int row(std::size_t node) const { return static_cast<int>(node / static_cast<std::size_t>(fine_.columns())); }
  std::size_t sub_cell(std::size_t cell, int k = 0) const {
    return fine_.at(2 * cells_.column(cell) + k % 2, 2 * cells_.row(cell) + k / 2);
  }
  std::size_t coarse(std::size_t node) const { return cells_.at(column(node) / 2, row(node) / 2); }
  bool left(std::size_t node) const {  // in a part that has not been come to
    const int part = parts_.of[coarse(node)];
    return part >= 0 && !done_[static_cast<std::size_t>(part)];
  }

  const Problem& problem_;
  const GridGraph& fine_;
  const CoarseCells& cells_;
  const CoarseParts& parts_;
  LatticePaths& ways_;
  std::vector<bool> done_;            // parts
  std::vector<int> left_;             // parts not yet come to, by part of the lattice
  std::optional<NearestComponent> walls_;  // made at the first question
  std::size_t at_ = 0;                // the last entry's sub-cell
};

}  // namespace oxturn
