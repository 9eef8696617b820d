/// TLPPA: a collision-free path by graph search on a quantised configuration space, on two levels.
///
///   Tlppa tlppa(problem, 0.1);
///   std::optional<Polyline> path = tlppa.path(from, to);      // nullopt: the cells show none
///
/// Source      after W. K. Hyun, "A hierarchical collision-free path planning algorithm for robots", IROS 1995, as
///             cited and outlined in his paper on heuristic sweeping; the IROS paper itself was not available
/// Complexity  N fine cells: build O(N + edges of the space); a path O(c log c) for c cells opened on both levels, of
///             which the fine ones lie beside the coarse path. Memory 5 bytes a fine cell, 32 a coarse one and 16 a
///             cell of the largest box around a corridor.
/// Guarantee   every path lies in configuration space. None is found where the only passages are narrower than two or
///             three fine cells (resolution-complete).
/// Decisions   1. A fine cell is free if it lies entirely in configuration space. So do then the steps to its eight
///                neighbours that are free, diagonal ones too (the space is closed).
///             2. A coarse cell is a block of 8 x 8 fine ones, or each connected part of it where walls divide the free
///                cells of a block: so every coarse path can be driven. Two are neighbours if a step leads across.
///                Coarse A* measures by block centres.
///             3. The fine search is A* within the blocks of the coarse path and their eight neighbours. Whether steps
///                connect two cells at all is computed beforehand.
///             4. Ends need not be cell centres: each is connected to the nearest free cell centre that is in sight, at
///                most `kReach` cells away.
///             5. Nothing is smoothed, because the source does not mention it. Straight runs of cells become one
///                segment.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/graph_search.hpp"
#include "geometry/raster.hpp"
#include "maps/problem.hpp"

namespace oxturn {

class Tlppa {
 public:
  /// `cell`: side of a fine cell, metres; enlarged where the space would need more than 2^22 of them.
  Tlppa(const Problem& problem, double cell);
  /// From a to b, both included. nullopt if the cells show none. Not safe from several threads.
  std::optional<Polyline> path(const Point& a, const Point& b);

 private:
  struct Cell {
    int i, j;
  };
  /// Columns left .. right and rows bottom .. top of a grid.
  struct Window {
    int left, bottom, right, top;
  };
  using Cells = std::vector<Cell>;
  void find_coarse_cells();
  template <class F>
  void for_each_step(std::size_t coarse, F f) const;
  std::optional<Cell> connect(const Point& p) const;
  std::int32_t component(const Cell& c) const { return components_.of[coarse_of_[fine_.at(c.i, c.j)]]; }
  std::size_t block_at(const Cell& block) const {
    return static_cast<std::size_t>(block.j) * static_cast<std::size_t>(block_columns_) +
           static_cast<std::size_t>(block.i);
  }
  Cells coarse_path(const Cell& from, const Cell& to);
  Window mark_corridor(const Cells& blocks);
  Cells fine_path(const Cell& from, const Cell& to);

  const Problem& problem_;
  static constexpr std::uint32_t kNone = 0xffffffff;
  BitGrid fine_;
  int block_columns_ = 0, block_rows_ = 0;
  std::vector<std::uint32_t> coarse_of_;  // of each fine cell; kNone: it is not free
  Cells coarse_;                          // the block of each coarse cell
  ConnectedComponents components_;        // of the coarse cells
  SearchTree<double> coarse_search_, fine_search_;
  std::vector<std::uint32_t> corridor_of_;  // blocks: the last query whose corridor they belonged to
  std::uint32_t queries_ = 0;
};

}  // namespace oxturn
