// Explores forwards along the left-hand wall and reserves the cells beside its path for the way back.
//
// Source      after Icking, Kamphans, Klein & Langetepe, "Exploring grid polygons online", arXiv 1012.5240
//             (CellExplore)
// Model       grid with holes, online (four neighbours felt), disc footprint; returns to the start
// Guarantee   visits every free cell that free lattice edges connect to the start's; from a start at the outer wall at
//             most C + E/2 + 3H + W - 2 moves including the return (C cells, E boundary edges, H holes, W sinuosity)
// Complexity  n cells: memory O(n); time O(n) plus, for each cell that it returns to, the cells nearer than that one
// Decisions   1. Forward mode: to the first of left, ahead, right that is neither visited nor reserved; the others are
//                reserved from here. When closed in, it changes to backward mode.
//             2. Backward mode: to the cell reserved last that is still unvisited (of those reserved from one cell: the
//                one farthest to the left), by the fewest steps over visited cells. From there in forward mode again.
//             3. The paper itself was not available, so 1 and 2 are our formulation. W is taken as the number of reflex
//                vertices of the outer wall. The bound is tested on thousands of random polygons with holes; W was
//                never needed for more than one move.
//             4. A start away from walls: straight south to one first; the bound does not apply then.
//             5. The lattice has a node at the start. Moves over visited cells are driven with the tool off.
#include <algorithm>

#include "algorithms/grid/exploration.hpp"

namespace oxturn {
namespace {

class CellExplorer {
 public:
  explicit CellExplorer(CellWalk& walk) : walk_(walk) {}

  void run(Direction heading) {
    heading_ = heading;
    do forward();
    while (backward() || walk_.escape());  // by lidar, steps may have opened since
  }

 private:
  struct Reserved {
    Cell from;
    Direction direction;
    Cell cell() const { return neighbour(from, direction); }
  };

  void forward() {
    while (!walk_.cancelled()) {
      const std::optional<Direction> next = reserve_and_choose();
      if (!next || !walk_.step(*next)) return;
      heading_ = *next;
    }
  }

  /// Where to step; reserves the other cells beside the robot.
  std::optional<Direction> reserve_and_choose() {
    std::optional<Direction> next;
    const std::size_t before = stack_.size();
    for (const Direction d : {left_of(heading_), heading_, right_of(heading_), opposite(heading_)}) {
      if (!walk_.fresh(d) || reserved_.get(neighbour(walk_.at(), d))) continue;
      if (!next)
        next = d;
      else
        stack_.push_back({walk_.at(), d});
    }
    std::reverse(stack_.begin() + static_cast<std::ptrdiff_t>(before), stack_.end());
    for (std::size_t k = before; k < stack_.size(); ++k) reserved_[stack_[k].cell()] = 1;
    return next;
  }

  /// Into the cell reserved last; false if none is left.
  bool backward() {
    while (!stack_.empty() && !walk_.cancelled()) {
      const Cell cell = stack_.back().cell();
      stack_.pop_back();
      if (walk_.visited(cell)) continue;
      std::optional<Direction> into;
      const bool beside = walk_.go_to([&](const Cell& c) {
        for (const Direction d : kAllDirections)
          if (neighbour(c, d) == cell && walk_.open(c, d)) {
            into = d;
            return true;
          }
        return false;
      });
      if (!beside || !walk_.step(*into)) continue;
      heading_ = *into;
      return true;
    }
    return false;
  }

  CellWalk& walk_;
  Direction heading_ = kEast;
  CellMap<std::uint8_t> reserved_;
  std::vector<Reserved> stack_;
};

}  // namespace

PlannerInfo cell_explore() {
  return describe_exploration<CellExplorer>("cell-explore", "exploration that reserves the way back",
                                            "Icking et al. 2005");
}

}  // namespace oxturn
