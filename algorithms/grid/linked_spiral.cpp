// Spirals by straight runs, linked by a distance wave over what has been covered.
//
// Source      after Choi, Lee, Baek & Oh, "Online complete coverage path planning for mobile robots based on linked
//             spiral paths using constrained inverse distance transform", IROS 2009
// Model       grid, online (four neighbours felt), disc footprint
// Guarantee   visits every free cell that free lattice steps join to the start's
// Complexity  n cells: memory O(n); time O(n) plus, for each spiral's end, the cells nearer than the next one's start
// Decisions   1. A spiral runs straight on until blocked by a wall or a visited cell, then turns to the turning side, or to
//                the other one if only that is free. The turning side is away from where the spiral began to be blocked:
//                left, unless the right hand is free there and the left is not. (`bsa` hugs its reference side instead.)
//             2. The constrained inverse distance transform: a wave from the robot over visited cells only, stopped at the
//                first that has an unvisited neighbour; the robot goes there. Its new spiral begins along what is covered:
//                with a wall or a visited cell on the side away from the turning side, if that can be.
//             3. "Map coordinate assignment" turns the grid with the walls: `align = edges`, known from the map.
//             4. The lattice hangs on the start. Links are driven with the tool off.
#include "algorithms/grid/cell_planner.hpp"
#include "algorithms/grid/cell_walk.hpp"

namespace oxturn {
namespace {

struct Params {
  double cell_size = 0;
  std::string align = "axes";
  std::string sensing = "map";
};

class LinkedSpirals {
 public:
  explicit LinkedSpirals(CellWalk& walk) : walk_(walk) {}

  void run() {
    do {
      if (walk_.any_fresh()) begin();
      while (step()) {}
    } while (walk_.escape());
  }

 private:
  static Direction turned(Direction d, bool left) { return left ? left_of(d) : right_of(d); }

  // Faces along what is covered or a wall, if that can be.
  void begin() {
    turns_.reset();
    for (const Direction d : kAllDirections)
      if (walk_.fresh(d) && !walk_.fresh(right_of(d))) {
        heading_ = d;
        return;
      }
    while (!walk_.fresh(heading_)) heading_ = left_of(heading_);
  }

  bool step() {
    if (walk_.cancelled()) return false;
    if (walk_.fresh(heading_) && walk_.step(heading_)) return true;
    if (!turns_) turns_ = walk_.fresh(left_of(heading_)) || !walk_.fresh(right_of(heading_));
    for (const bool left : {*turns_, !*turns_}) {
      const Direction d = turned(heading_, left);
      if (!walk_.fresh(d) || !walk_.step(d)) continue;
      heading_ = d;
      return true;
    }
    return false;
  }

  CellWalk& walk_;
  Direction heading_ = kEast;
  std::optional<bool> turns_;  // to the left
};

class LinkedSpiral final : public CoveragePlanner {
 public:
  explicit LinkedSpiral(Params p) : p_(std::move(p)) {}
  Path plan(const Problem& problem, Context& context) const override {
    return walk_cells(problem, context, {p_.cell_size, p_.align, p_.sensing}, [&](CellRobot& robot) {
      CellWalk walk(robot, context);
      LinkedSpirals(walk).run();
      walk.report();
    });
  }

 private:
  Params p_;
};

}  // namespace

PlannerInfo linked_spiral() {
  return describe<LinkedSpiral, Params>(
      {.name = "linked-spiral",
       .family = "grid",
       .title = "spirals linked by a distance wave",
       .citation = "Choi et al. 2009",
       .capabilities = {Capability::holes, Capability::online},
       .guarantee = "visits every free cell that free lattice steps join to the start",
       .parameters = {
           {"cell_size", &Params::cell_size, Range{0, 1000}, "side of a cell, metres; 0: tool width / sqrt 2"},
           {"align", &Params::align, Choices{"axes", "edges"}, kAlignHelp},
           {"sensing", &Params::sensing, Choices{"map", "lidar"}, kSensingHelp}}});
}

}  // namespace oxturn
