// The connected parts of the free coarse cells, and the tree in each.
//
// Complexity  parts, and the trees together, O(cells), `weighted` O(cells log cells)
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "algorithms/lattice/coarse_cells.hpp"
#include "base/random.hpp"

namespace oxturn {

/// A number for each coarse cell, -1 for those that are not free.
struct CoarseParts {
  std::vector<int> of;
  int count = 0;
};
CoarseParts parts_of(const CoarseCells& cells);

/// In which order depth-first growth tries the neighbours of a cell come to in direction `came`: `straight`, on as one
/// came if possible; else counter-clockwise from east; `shuffled` (may be null) decides anew.
std::array<Direction, 4> depth_first_order(Direction came, bool straight, Rng* shuffled);

/// Links one part after another to trees: bfs, dfs, minimum-turn, random, weighted.
class TreeGrower {
 public:
  /// All must outlive it.
  TreeGrower(CoarseCells& cells, const std::string& kind, Rng& rng);
  /// Links the part that holds `root`, once. O(cells of the part); `weighted` with a sort.
  void grow(std::size_t root);

 private:
  static constexpr std::uint32_t kAlone = std::numeric_limits<std::uint32_t>::max();
  void grow_weighted(std::size_t root);
  CoarseCells& cells_;
  const std::string& kind_;
  Rng& rng_;
  std::vector<std::uint32_t> parent_;  // weighted: the forest of sets that are joined
};

}  // namespace oxturn
