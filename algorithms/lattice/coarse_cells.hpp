// Coarse cells of two by two sub-cells, a tree of them, and the way round it: what spanning tree coverage is made of.
//
// Source      Gabriely & Rimon, "Spanning-tree based coverage of continuous areas by a mobile robot", ICRA 2001
// Complexity  everything O(cells)
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "algorithms/lattice/grid_graph.hpp"

namespace oxturn {

/// The coarse cells over a lattice of sub-cells, with the tree edges chosen so far (a bit for each direction).
class CoarseCells {
 public:
  /// A coarse cell is free if the square through its four sub-cell centres, which is all that is driven inside it, is.
  /// `fine` must outlive it.
  explicit CoarseCells(const GridGraph& fine);

  std::size_t size() const { return free_.size(); }
  std::size_t at(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(i);
  }
  int column(std::size_t c) const { return static_cast<int>(c % static_cast<std::size_t>(columns_)); }
  int row(std::size_t c) const { return static_cast<int>(c / static_cast<std::size_t>(columns_)); }
  bool free(std::size_t c) const { return free_[c]; }
  /// Some tree edge ends here.
  bool linked(std::size_t c) const { return tree_[c] != 0; }
  bool in_tree(std::size_t c, Direction d) const { return (tree_[c] >> d & 1) != 0; }

  /// Adjacent: both neighbours free, and both ways between their sub-cells.
  bool adjacent(std::size_t c, Direction d) const;
  std::size_t neighbour(std::size_t c, Direction d) const {
    return at(column(c) + kColumnStep[d], row(c) + kRowStep[d]);
  }
  void link(std::size_t c, Direction d) {
    tree_[c] |= static_cast<std::uint8_t>(1 << d);
    tree_[neighbour(c, d)] |= static_cast<std::uint8_t>(1 << opposite(d));
  }
  Point centre(std::size_t c) const { return fine_.centre(2 * column(c) + 0.5, 2 * row(c) + 0.5); }

 private:
  const GridGraph& fine_;
  int columns_, rows_;
  std::vector<bool> free_;
  std::vector<std::uint8_t> tree_;
};

/// Links all cells that hang together with `root`, no deeper than `deepest`, to a breadth-first tree (neighbours
/// counter-clockwise from east). Returns them, nearest first. None of them may be linked before. O(cells linked).
std::vector<std::size_t> grow_breadth_first(CoarseCells& cells, std::size_t root,
                                            std::size_t deepest = std::numeric_limits<std::size_t>::max());

/// Round the tree, counter-clockwise: where the way goes on from sub-cell (i, j).
Direction round_step(const CoarseCells& cells, int i, int j);
/// The closed way round the tree from sub-cell (i0, j0), counter-clockwise: each sub-cell of the tree's cells once.
/// `every_cell`: a point for each, not only where the way turns.
Polyline round_tree(const GridGraph& fine, const CoarseCells& cells, int i0, int j0, bool every_cell = false);

/// A segment for every tree edge: for pictures.
std::vector<Polyline> tree_lines(const CoarseCells& cells);

}  // namespace oxturn
