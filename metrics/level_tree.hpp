/// The tree of the parts of configuration space that lie farther from the start than a given distance, in slabs of
/// distance. Private to metrics/.
///
///   const std::optional<LevelTree> tree = level_tree(cells);
///
///      start                 A slab is a part of a branch between two distances from the start. Its parent is the next
///   ____|________________    one towards the start. Where two branches meet, a slab has two children; a dead end is a
///   |___|___|___|___|___|    slab without children.
///         |___|
///         |___|
///
/// Source      the join tree of Carr, Snoeyink and Axen, "Computing contour trees in all dimensions", 2003
/// Complexity  O(n log n) for n cells, and the cells within reach of the tool for each part of the target
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "metrics/level_cells.hpp"

namespace oxturn {

struct LevelTree {
  static constexpr std::int32_t kNone = -1;
  struct Slab {
    std::int32_t parent = kNone;  // has a higher index
    double low = 0, high = 0;     // distances from the start
    double only = 0;              // area of the target that can only be covered from beyond a distance in this slab
    double near = 0;              // area of the target in and next to the slab, for estimates
    double length() const { return high - low; }
  };
  std::vector<Slab> slabs;
  std::vector<std::int32_t> of_cell;  // that holds the cell's greatest distance
  std::vector<std::int32_t> of_part;  // whose `only` holds it; kNone: it can be covered from several branches
};

/// Slabs are as thick as cells are wide, at most. nullopt if the cells are not connected.
std::optional<LevelTree> level_tree(const LevelCells& cells);

/// The columns on either side that the tool reaches in a row so many rows away, from anywhere in one cell to anywhere
/// in another; by row. Lengths in cells.
std::vector<int> tool_reach(double side);

}  // namespace oxturn
