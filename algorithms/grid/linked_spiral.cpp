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
//             4. partial = true (by map only): from each cell beside walls through cells that the robot cannot stand in the
//                middle of, their contour is followed once, as `bsa` does it, when the spiral has ended.
//             5. The lattice hangs on the start. Links are driven with the tool off.
#include "algorithms/grid/cell_planner.hpp"
#include "algorithms/lattice/cell_walk.hpp"
#include "algorithms/grid/wall_follower.hpp"

namespace oxturn {
namespace {

struct Params {
  double cell_size = 0;
  bool partial = false;
  std::string align = "axes";
  std::string sensing = "map";
};

class LinkedSpirals {
 public:
  LinkedSpirals(CellWalk& walk, WallFollower* walls) : walk_(walk), walls_(walls) {}

  void run() {
    do {
      if (walk_.any_fresh()) begin();
      while (step()) {}
    } while (link());
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

  bool link() {
    if (!walls_) return walk_.escape();
    const auto left_over = [&](const Cell& c) { return walk_.any_fresh(c) || walls_->any_left(c); };
    while (walk_.go_to(left_over)) {
      walls_->follow_all(walk_, false);
      if (walk_.any_fresh()) return true;
    }
    return false;
  }

  CellWalk& walk_;
  WallFollower* walls_;
  Direction heading_ = kEast;
  std::optional<bool> turns_;  // to the left
};

class LinkedSpiral final : public CoveragePlanner {
 public:
  explicit LinkedSpiral(Params p) : p_(std::move(p)) {}
  Path plan(const Problem& problem, Context& context) const override {
    return walk_cells(problem, context, {p_.cell_size, p_.align, p_.sensing, 1, false, p_.partial},
                      [&](CellRobot& robot) {
                        CellWalk walk(robot, context);
                        std::optional<WallFollower> walls;
                        if (p_.partial) walls.emplace(problem, robot);
                        LinkedSpirals(walk, walls ? &*walls : nullptr).run();
                        if (walls) context.record("along_walls_m", walls->length());
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
           {"partial", &Params::partial, "follow walls through cells that are not wholly free (sensing = map)"},
           {"align", &Params::align, Choices{"axes", "edges"}, kAlignHelp},
           {"sensing", &Params::sensing, Choices{"map", "lidar"}, kSensingHelp}}});
}

}  // namespace oxturn
