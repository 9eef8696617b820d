#include "algorithms/grid/stc_online.hpp"

#include <array>

#include "algorithms/grid/cell_planner.hpp"
#include "algorithms/grid/sub_cell_tree.hpp"

namespace oxturn {
namespace {

constexpr int kReach = 3;  // sub-cells: from a corner of a coarse cell over the whole of its eight neighbours

template <class Tree>
class Growth {
 public:
  Growth(Tree& tree, bool partial, bool scan) : tree_(tree), partial_(partial), scan_(scan) {}

  // The robot looks out of c over side d. A double-sided edge begins at the side's first sub-cell: there the robot comes
  // by as well, and the tree is at its left.
  bool operator()(const Cell& c, Direction d) {
    const Cell across = neighbour(c, d);
    if (tree_.holds(across) || !tree_.passable(c, d)) return false;
    if (tree_.inner(c, d)) {  // felt blocked when the node was taken in, and free now: by lidar only
      if (!partial_) return false;
    } else {
      const bool both = tree_.two_ways(c, d);
      if (both && !tree_.first_on_side(c, d)) return false;
      if (!partial_ && (!both || !tree_.whole(across))) return false;
      if (scan_ && postponed(c, d)) return false;
    }
    tree_.link(c, d);
    return true;
  }

 private:
  static Cell coarse_neighbour(const Cell& base, Direction d) { return neighbour(neighbour(base, d), d); }
  bool fresh(const Cell& base) const { return !tree_.holds(base) && tree_.whole(base); }
  // Both ways over side d of the coarse cell.
  bool adjacent(const Cell& base, Direction d) const {
    const Cell east = neighbour(base, kEast), north = neighbour(base, kNorth);
    switch (d) {
      case kEast:
        return tree_.passable(east, d) && tree_.passable(neighbour(north, kEast), d);
      case kNorth:
        return tree_.passable(north, d) && tree_.passable(neighbour(north, kEast), d);
      case kWest:
        return tree_.passable(base, d) && tree_.passable(north, d);
      default:
        return tree_.passable(base, d) && tree_.passable(east, d);
    }
  }
  // Sideways to y, while x's vertical neighbour x' and y's, y', are free and new: x' is later in x's order (or it would
  // be old), and y is come to from y'. All four must hang together by double-sided edges, or y might be forgotten.
  bool postponed(const Cell& c, Direction d) const {
    if (d == kNorth || d == kSouth || !tree_.whole(c)) return false;
    const Cell x = tree_.base(c), y = coarse_neighbour(x, d);
    if (!fresh(y)) return false;
    for (const Direction v : {kNorth, kSouth}) {
      const Cell above = coarse_neighbour(x, v), beside = coarse_neighbour(y, v);
      if (fresh(above) && fresh(beside) && adjacent(x, v) && adjacent(above, d) && adjacent(y, v)) return true;
    }
    return false;
  }

  Tree& tree_;
  bool partial_, scan_;
};

}  // namespace

Path grow_and_go_round(const Problem& problem, Context& context, const OnlineStcParams& params, bool scan) {
  return walk_cells(problem, context, {params.cell_size, params.align, params.sensing, kReach}, [&](CellRobot& robot) {
    const auto passable = [&](const Cell& c, Direction d) { return robot.passable(c, d); };
    using Tree = SubCellTree<decltype(passable)>;
    // The start may be any of the four sub-cells of its coarse cell: the first choice that is wholly free.
    Cell corner;
    bool whole = false;
    for (const Cell& choice : {Cell{0, 0}, Cell{-1, 0}, Cell{0, -1}, Cell{-1, -1}}) {
      whole = Tree(passable, choice).whole(choice);
      if (!whole) continue;
      corner = choice;
      break;
    }
    if (!whole && !params.partial)
      throw Infeasible("no coarse cell of twice the cell size fits about the start; partial = true may help");
    Tree tree(passable, corner);
    tree.add_node({0, 0});
    tree.round({0, 0}, Growth<Tree>(tree, params.partial, scan),
               [&](Direction d) { return !((robot.steps() & 1023) == 0 && context.cancelled()) && robot.step(d); });
    context.record("steps", static_cast<double>(robot.steps()));
  });
}

std::vector<Parameter<OnlineStcParams>> online_stc_parameters() {
  using P = OnlineStcParams;
  return {{"cell_size", &P::cell_size, Range{0, 1000}, "side D of a sub-cell, metres; 0: tool width / sqrt 2"},
          {"partial", &P::partial, "also enter coarse cells of which only some sub-cells are free (2002)"},
          {"align", &P::align, Choices{"axes", "edges"}, kAlignHelp},
          {"sensing", &P::sensing, Choices{"map", "lidar"}, kSensingHelp}};
}

}  // namespace oxturn
