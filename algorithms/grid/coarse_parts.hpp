// The connected parts of the free coarse cells, the tree in each, and in which order they are come to.
//
// Complexity  parts, and the trees together, O(cells); `weighted` with near-constant factors more
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/grid/coarse_cells.hpp"
#include "algorithms/grid/nearest_part.hpp"
#include "geometry/random.hpp"

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

/// Links the part that holds `root` to a tree: bfs, dfs, minimum-turn, random, weighted.
void grow_tree(CoarseCells& cells, std::size_t root, const CoarseParts& parts, const std::string& kind, Rng& rng);

/// The parts, nearest first, each by the sub-cell where it is come to.
class PartsInOrder {
 public:
  PartsInOrder(const Problem& problem, const GridGraph& fine, const CoarseCells& cells, const CoarseParts& parts);
  struct Entry {
    int i, j;            // sub-cell
    std::size_t coarse;  // cell
    Polyline way;        // to it, from where was asked
  };
  /// The nearest part not yet come to; it then is. The start may stand in the middle of a part: `first` looks for the
  /// sub-cell under it. nullopt if none can be reached.
  std::optional<Entry> next(const Point& from, bool first);

 private:
  std::optional<NearestPart::Found> under(const Point& p) const;
  const Problem& problem_;
  const GridGraph& fine_;
  const CoarseCells& cells_;
  const CoarseParts& parts_;
  NearestPart nearest_;
};

}  // namespace oxturn
