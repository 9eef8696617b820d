#include "algorithms/grid/stc_online.hpp"

#include "algorithms/grid/cell_planner.hpp"
#include "algorithms/lattice/promised_cells.hpp"
#include "algorithms/lattice/sub_cell_tree.hpp"

namespace oxturn {
namespace {

constexpr int kReach = 3;  // sub-cells: from any sub-cell across all eight neighbours of its coarse cell
constexpr std::size_t kStepsPerLookAtClock = 1024;

/// Decides where the tree grows as the robot looks across the sides of its cells.
template <class Tree>
class Growth {
 public:
  Growth(Tree& tree, bool partial, ChildOrder order) : tree_(tree), partial_(partial), order_(order) {}

  // The robot looks from c across its side d. A double-sided edge begins at the side's first sub-cell: the robot passes
  // there as well, with the tree on its left.
  bool operator()(const Cell& c, Direction d) {
    const Cell across = neighbour(c, d);
    if (tree_.contains(across) || !tree_.passable(c, d)) return false;
    if (tree_.inner(c, d)) {  // blocked when the node was added and free now: by lidar only
      if (!partial_) return false;
    } else {
      const bool both = tree_.double_sided(c, d);
      if (both && !tree_.first_on_side(c, d)) return false;
      if (!partial_ && (!both || !tree_.whole(across))) return false;
      if (order_ == ChildOrder::vertical_first && left_to_vertical_neighbour(c, d)) return false;
    }
    tree_.link(c, d);
    return true;
  }

 private:
  static Cell coarse_neighbour(const Cell& base, Direction d) { return neighbour(neighbour(base, d), d); }
  /// Not in the tree, and entirely free.
  bool is_new(const Cell& base) const { return !tree_.contains(base) && tree_.whole(base); }
  /// Both lattice edges across side d of the coarse cell are free.
  bool adjacent(const Cell& base, Direction d) const {
    Cell first = base;  // the lower or left one of the side's two sub-cells
    if (d == kEast || d == kNorth) first = neighbour(first, d);
    const Cell second = neighbour(first, d == kEast || d == kWest ? kNorth : kEast);
    return tree_.passable(first, d) && tree_.passable(second, d);
  }
  /// Whether child y of x, sideways in direction d, will be entered from its own vertical neighbour: x' (above or below
  /// x) and y' (beside it) are new, so x' comes later in x's order and leads to y', and y' to y. All four must be
  /// connected by double-sided edges, or y might be forgotten.
  bool left_to_vertical_neighbour(const Cell& c, Direction d) const {
    if (d == kNorth || d == kSouth || !tree_.whole(c)) return false;
    const Cell x = tree_.base(c), y = coarse_neighbour(x, d);
    if (!is_new(y)) return false;
    for (const Direction v : {kNorth, kSouth}) {
      const Cell above_x = coarse_neighbour(x, v), above_y = coarse_neighbour(y, v);
      if (is_new(above_x) && is_new(above_y) && adjacent(x, v) && adjacent(above_x, d) && adjacent(y, v)) return true;
    }
    return false;
  }

  Tree& tree_;
  bool partial_;
  ChildOrder order_;
};

/// The start may be any of the four sub-cells of its coarse cell. The first choice of the cell's lower left sub-cell
/// for which it is entirely free; nullopt if there is none.
template <class Tree, class Passable>
std::optional<Cell> whole_cell_at_start(const Passable& passable) {
  for (const Cell& corner : {Cell{0, 0}, Cell{-1, 0}, Cell{0, -1}, Cell{-1, -1}})
    if (Tree(passable, corner).whole(corner)) return corner;
  return std::nullopt;
}

/// `corner`: the lower left sub-cell of the coarse cell at the start.
void promise_coarse(const CellRobot& robot, const Cell& corner, const Problem& problem, Context& context) {
  const CellRobot::Lattice lattice = robot.lattice();
  const Cell base{lattice.first.i + corner.i, lattice.first.j + corner.j};
  promise_coarse_cells(context, lattice.graph, Components::start, base, problem.robot().tool_width);
}

}  // namespace

template <ChildOrder order>
Path cover_by_growing_tree(const OnlineStcOptions& options, const Problem& problem, Context& context) {
  return drive_cells(problem, context, options, {.reach = kReach, .all_cells = options.partial}, [&](CellRobot& robot) {
    const auto passable = [&](const Cell& c, Direction d) { return robot.passable(c, d); };
    using Tree = SubCellTree<decltype(passable)>;
    const std::optional<Cell> corner = whole_cell_at_start<Tree>(passable);
    if (!corner && !options.partial)
      throw Infeasible("no coarse cell of twice the cell size fits at the start; partial = true may help");
    if (!options.partial && options.sensing == Sensing::map) promise_coarse(robot, *corner, problem, context);
    Tree tree(passable, corner.value_or(Cell{0, 0}));
    tree.add_node({0, 0});
    tree.go_round({0, 0}, Growth<Tree>(tree, options.partial, order), [&](Direction d) {
      return !(robot.steps() % kStepsPerLookAtClock == 0 && context.cancelled()) && robot.step(d);
    });
    context.record("steps", static_cast<double>(robot.steps()));
  });
}
template Path cover_by_growing_tree<ChildOrder::counter_clockwise>(const OnlineStcOptions&, const Problem&, Context&);
template Path cover_by_growing_tree<ChildOrder::vertical_first>(const OnlineStcOptions&, const Problem&, Context&);

}  // namespace oxturn
