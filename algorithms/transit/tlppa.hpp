// TLPPA: a collision-free way by graph search on a quantised configuration space, on two levels.
//
// Source      after W. K. Hyun, "A hierarchical collision-free path planning algorithm for robots", IROS 1995, as cited
//             and outlined in his sweeping paper; the IROS paper itself was not at hand
// Complexity  N fine cells: build O(N + edges of the space); a way O(c log c) for c cells opened on both levels, O(N log N)
//             at worst. Memory 5 bytes a fine cell, 16 a coarse one and 16 a cell of the largest box about a corridor.
// Guarantee   every way lies in configuration space. None is found where the only passages are narrower than two or three
//             fine cells: the cells are what it knows (resolution-complete).
// Decisions   1. A fine cell is free if it lies wholly in configuration space; so does then a step to any of its eight
//                neighbours that is free, corner to corner too (the space is closed).
//             2. A coarse cell is a block of 8 x 8 fine ones, open if any of them is free; two blocks are neighbours if a
//                step leads across. Coarse A* goes by block centres.
//             3. The fine search is A* within the blocks of the coarse way and their eight neighbours; if that fails, over
//                all fine cells. Cells that no steps join are known beforehand.
//             4. Ends need not be cell centres: each is joined to the nearest free cell's centre that it sees, among the
//                cells within `kReach` cells.
//             5. Nothing is smoothed: the source does not speak of it. Straight runs of cells become one segment.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/raster.hpp"
#include "maps/problem.hpp"

namespace oxturn {

class Tlppa {
 public:
  /// `cell`: side of a fine cell, metres; made larger where the space would take more than 2^22 of them.
  Tlppa(const Problem& problem, double cell);
  /// From a to b, both included. nullopt if the cells show none. Not safe from several threads.
  std::optional<Polyline> path(const Point& a, const Point& b);

 private:
  /// What A* notes of the cells of a window, from search to search: a search touches only what it opens.
  struct Notes {
    struct Note {
      double cost;
      std::uint32_t search;  // by which it was seen
      std::int8_t came;
      bool closed;
    };
    std::vector<Note> of;
    std::uint32_t search = 0;
  };
  /// Columns left .. right and rows bottom .. top of a grid.
  struct Window {
    int left, bottom, right, top;
  };
  template <class May>
  static std::vector<std::size_t> search(const BitGrid& grid, const Window& w, std::size_t from, std::size_t to,
                                         Notes& notes, May may);
  void number_parts();
  std::optional<std::size_t> join(const Point& p) const;
  std::vector<std::size_t> corridor(std::size_t from, std::size_t to);
  const Problem& problem_;
  BitGrid fine_, coarse_;
  std::vector<std::int32_t> part_;  // of the fine cells: joined by steps; -1: not free
  Notes on_fine_, on_coarse_;
  std::vector<std::uint32_t> may_;  // blocks: the last way whose corridor they were in
  std::uint32_t ways_ = 0;
};

}  // namespace oxturn
