/// Coarse cells of two by two sub-cells, a spanning tree of them, and the path around the tree: the parts of spanning
/// tree coverage.
///
///   CoarseCells cells(fine);
///   grow_breadth_first(cells, cells.at(0, 0));
///   path.drive(round_tree(fine, cells, {0, 0}), true);
///
///   +-------+-------+
///   | o - o - o - o |     o  sub-cell centres, joined by the closed path
///   | |   *---*   | |     *  centres of the coarse cells, joined by the tree
///   | o - o - o - o |
///   +-------+-------+
///
/// Gabriely and Rimon 2001 ("Spanning-tree based coverage of continuous areas by a mobile robot", ICRA).
/// Everything O(cells).
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "algorithms/lattice/grid_graph.hpp"

namespace oxturn {

/// The coarse cells over a lattice of sub-cells, with the tree edges chosen so far.
class CoarseCells : public CellNumbers {
 public:
  /// A coarse cell is free if the square through its four sub-cell centres is: nothing else is driven inside it.
  /// `fine` must outlive it.
  explicit CoarseCells(const GridGraph& fine);

  bool free(std::size_t c) const { return free_[c]; }
  /// Some tree edge ends here.
  bool linked(std::size_t c) const { return tree_[c] != 0; }
  bool in_tree(std::size_t c, Direction d) const { return (tree_[c] >> d & 1) != 0; }

  /// Both cells are free, and so are the two lattice edges between their sub-cells.
  bool adjacent(std::size_t c, Direction d) const;
  std::size_t neighbour(std::size_t c, Direction d) const { return at(oxturn::neighbour(cell(c), d)); }
  void link(std::size_t c, Direction d) {
    tree_[c] |= static_cast<std::uint8_t>(1 << d);
    tree_[neighbour(c, d)] |= static_cast<std::uint8_t>(1 << opposite(d));
  }
  Point centre(std::size_t c) const { return fine_.centre(2 * column(c) + 0.5, 2 * row(c) + 0.5); }

 private:
  const GridGraph& fine_;
  std::vector<bool> free_;
  std::vector<std::uint8_t> tree_;  // of each cell a bit for each direction
};

/// Links all cells that are connected to `root` by at most `deepest` edges to a breadth-first tree; neighbours are
/// taken counter-clockwise from east. Returns them, nearest first. None of them may be linked before. O(cells linked).
std::vector<std::size_t> grow_breadth_first(CoarseCells& cells, std::size_t root,
                                            std::size_t deepest = std::numeric_limits<std::size_t>::max());

/// Counter-clockwise around the tree: where the path leads from a sub-cell.
Direction round_step(const CoarseCells& cells, const Cell& at);
/// The steps once around the tree, from a sub-cell back to it.
std::vector<Direction> steps_around(const CoarseCells& cells, const Cell& first);
enum class RoundPoints { at_turns, at_every_cell };
/// The closed path around the tree from sub-cell `first`, counter-clockwise: each sub-cell of the tree's cells once.
Polyline round_tree(const GridGraph& fine, const CoarseCells& cells, const Cell& first,
                    RoundPoints points = RoundPoints::at_turns);

/// A segment for every tree edge, for pictures.
std::vector<Polyline> tree_lines(const CoarseCells& cells);

}  // namespace oxturn
