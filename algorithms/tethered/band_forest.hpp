/// Cells in bands of similar tether distance, divided into pieces that form a forest.
///
///   const BandForest forest(cells);
///   for (const std::size_t c : forest.order()) visit(cells[c]);
///
///     band 2    a a b b      Band k contains the cells at distances k D <= d < (k + 1) D, for cells of side D. Its
///     band 1    a # # b      connected components are pieces. A component that several pieces of earlier bands lead
///     band 0     root        to (here behind the obstacle #) is divided where the paths to them are equally long. So
///                            one side of an obstacle is finished before the other: the split cells of Shnaps and
///                            Rimon.
///
/// Within a band, cells are adjacent over a side, or over a corner if a cell beside it is free to both: otherwise the
/// stairs of a grid would divide every slanting band.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "algorithms/tethered/tether_cells.hpp"

namespace oxturn {

/// By (distance, row, column); distances that differ by rounding alone count as equal.
void sort_by_distance(CellList& list, const TetherCells& cells);

class BandForest {
 public:
  /// `cells` must outlive it. O(n log n) for n cells.
  explicit BandForest(const TetherCells& cells);
  /// All cells: depth-first over the pieces, the nearest child first. The tree of the start comes first, then the other
  /// trees (pieces that no earlier band leads to), always the nearest one.
  CellList order() const;
  /// A segment from each piece to its parent: for pictures.
  std::vector<Polyline> edges() const;

 private:
  using PieceList = std::vector<std::size_t>;
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  struct Piece {
    std::optional<std::size_t> parent;
    CellList cells;
  };

  PieceList nearest_first(const PieceList& some, const Point& at) const;
  void append_tree(std::size_t root, const std::vector<PieceList>& children, CellList& order) const;
  template <class F>
  void for_each_adjacent(std::size_t c, F f) const;
  CellList component_of(std::size_t seed);
  void divide(CellList component);
  CellList piece_around(std::size_t seed);
  void add(std::optional<std::size_t> parent, CellList cells);

  const TetherCells& cells_;
  std::vector<Piece> pieces_;
  // All by cell.
  std::vector<std::size_t> band_;
  std::vector<std::size_t> piece_;  // kNone: not decided yet
  std::vector<std::size_t> owner_;  // piece of an earlier band whose wave reached the cell first; kNone: not yet
  std::vector<bool> gathered_;      // in a component that was found
};

}  // namespace oxturn
