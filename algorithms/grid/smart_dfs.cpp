// Depth-first exploration with short returns: at a split, the part away from the way home is finished first.
//
// Source      after Icking, Kamphans, Klein & Langetepe, "Exploring simple grid polygons", COCOON 2005 (SmartDFS); the
//             same authors' "Exploring grid polygons online", arXiv 1012.5240
// Model       grid, online (the eight cells around the robot felt), disc footprint; returns to the start
// Guarantee   visits every free cell that free lattice edges connect to the start's; without holes and from a start at
//             the wall at most C + E/2 - 3 moves including the return (C cells, E boundary edges)
// Complexity  n cells: memory O(n); time O(n) plus, for each return, the cells nearer than its goal
// Decisions   1. Left-hand rule: left, ahead, right of the direction in which a cell was first entered. The robot
//                returns to a cell only if something is left to do there, by the fewest steps over visited cells.
//             2. A cell's layer is one more than the least layer among its eight neighbours; walls are layer 0, and
//                only cells that are walls or visited when the robot enters count.
//             3. A cell is a split cell if its unvisited neighbours are not connected around it: what lies between two
//                of them (the diagonal cell, or the cell ahead if they are left and right) is a wall or visited. Each
//                component of unvisited neighbours then has a boundary on its left and one on its right: at the far
//                left the layer outside, at the far right the robot's own layer, otherwise what lies between. A
//                component with the robot's own layer on one side only is partially surrounded (type III of the paper)
//                and is visited last. If there is none, the left-hand rule applies with its first step moved to the
//                end. (The paper's figures were not available, so this is our formulation. The bound is tested on
//                thousands of random polygons, and fails without this rule.)
//             4. A start away from walls: straight south to one first; the bound does not apply then.
//             5. The lattice has a node at the start. Moves over visited cells are driven with the tool off.
#include <algorithm>
#include <array>

#include "algorithms/grid/exploration.hpp"

namespace oxturn {
namespace {

class SmartDfs {
 public:
  explicit SmartDfs(CellWalk& walk) : walk_(walk) {}

  void run(Direction heading) {
    enter(heading);
    while (!stack_.empty() && !walk_.cancelled()) {
      Visit& visit = stack_.back();
      if (visit.next == visit.count) {
        stack_.pop_back();
        continue;
      }
      const Direction d = visit.order[visit.next++];
      const Cell base = visit.cell;
      if (walk_.fresh(base, d) && walk_.go_to_cell(base) && walk_.fresh(d) && walk_.step(d)) enter(d);
    }
    // By lidar, steps may have opened since.
    while (walk_.escape())
      for (const Direction d : kAllDirections)
        if (walk_.fresh(d)) walk_.step(d);
  }

 private:
  struct Visit {
    Cell cell;
    std::array<Direction, 3> order{};  // in which its unvisited neighbours are entered
    std::uint8_t count = 0, next = 0;
  };
  /// The components of a cell's unvisited neighbours.
  struct Split {
    std::array<std::uint8_t, 3> component{};  // of each direction in the order
    std::array<bool, 4> own_layer{};          // of what bounds component k on its left, k + 1 on its right
    std::uint8_t last = 0;
    bool partially_surrounded(std::uint8_t k) const { return own_layer[k] != own_layer[k + 1u]; }
  };

  /// Of a cell beside the robot's: 0 for a wall, nullopt if it is free and unvisited.
  std::optional<std::uint32_t> layer_of(const Cell& c) const {
    if (walk_.visited(c)) return layers_.get(c);
    if (!walk_.robot().free(c)) return 0;
    return std::nullopt;
  }

  std::uint32_t layer_here() const {
    const Cell at = walk_.at();
    std::uint32_t least = 0xffffffff;
    for (int di = -1; di <= 1; ++di)
      for (int dj = -1; dj <= 1; ++dj)
        if (di != 0 || dj != 0)
          if (const auto layer = layer_of({at.i + di, at.j + dj})) least = std::min(least, *layer + 1);
    return least;
  }

  void enter(Direction heading) {
    const Cell at = walk_.at();
    const std::uint32_t layer = layers_[at] = layer_here();
    Visit visit{.cell = at};
    Split split;
    for (const Direction d : {left_of(heading), heading, right_of(heading)}) {
      if (!walk_.fresh(d)) continue;
      if (visit.count > 0) {
        const Direction before = visit.order[visit.count - 1u];
        const Cell between = before == left_of(d) ? neighbour(neighbour(at, before), d) : neighbour(at, heading);
        if (const auto there = layer_of(between)) split.own_layer[++split.last] = *there == layer;
      }
      split.component[visit.count] = split.last;
      visit.order[visit.count++] = d;
    }
    split.own_layer[split.last + 1u] = true;
    if (split.last > 0) reorder(visit, split);
    stack_.push_back(visit);
  }

  /// Decision 3.
  static void reorder(Visit& visit, const Split& split) {
    std::array<Direction, 3> order{};
    std::size_t n = 0;
    const auto take = [&](bool partially_surrounded) {
      for (std::size_t k = 0; k < visit.count; ++k)
        if (split.partially_surrounded(split.component[k]) == partially_surrounded) order[n++] = visit.order[k];
    };
    take(false);
    if (n == visit.count) {
      std::rotate(visit.order.begin(), visit.order.begin() + 1, visit.order.begin() + visit.count);
      return;
    }
    take(true);
    visit.order = order;
  }

  CellWalk& walk_;
  CellMap<std::uint32_t> layers_;
  std::vector<Visit> stack_;
};

}  // namespace

PlannerInfo smart_dfs() {
  return describe_exploration<SmartDfs>("smart-dfs", "depth-first exploration with split cells", "Icking et al. 2005");
}

}  // namespace oxturn
