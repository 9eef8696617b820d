// TLPPA: a collision-free way by graph search on a quantised configuration space, on two levels.
//
// Source      after W. K. Hyun, "A hierarchical collision-free path planning algorithm for robots", IROS 1995, as cited
//             and outlined in his sweeping paper; the IROS paper itself was not at hand
// Complexity  N fine cells: build O(N + edges of the space); a way O(N / 64 + W + c log c) for a corridor of W cells, box
//             and all, and c cells opened; O(N log N) if the corridor fails. Memory 1 byte a fine cell, 10 a cell searched.
// Guarantee   every way lies in configuration space. None is found where the only passages are narrower than two or three
//             fine cells: the cells are what it knows (resolution-complete).
// Decisions   1. A fine cell is free if it lies wholly in configuration space; so does then a step to any of its eight
//                neighbours that is free, corner to corner too (the space is closed).
//             2. A coarse cell is a block of 8 x 8 fine ones, open if any of them is free; two blocks are neighbours if a
//                step leads across. Coarse A* goes by block centres.
//             3. The fine search is A* within the blocks of the coarse way and their eight neighbours; if that fails, over
//                all fine cells.
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
  /// From a to b, both included. nullopt if the cells show none.
  std::optional<Polyline> path(const Point& a, const Point& b) const;

 private:
  std::optional<std::size_t> join(const Point& p) const;
  std::vector<std::uint8_t> corridor(std::size_t from, std::size_t to) const;
  const Problem& problem_;
  BitGrid fine_, coarse_;
};

}  // namespace oxturn
