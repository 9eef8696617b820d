// Spirals of straight runs, linked by a distance wave over visited cells.
//
// Source      after Choi, Lee, Baek & Oh, "Online complete coverage path planning for mobile robots based on linked
//             spiral paths using constrained inverse distance transform", IROS 2009
// Model       grid, online (four neighbours felt), disc footprint
// Guarantee   visits every free cell that free lattice edges connect to the start's
// Complexity  n cells: memory O(n); time O(n) plus, for each spiral's end, the cells nearer than the next one's start
// Decisions   1. The robot drives straight until a wall or a visited cell blocks it, then turns to the turning side, or
//                to the other side if only that is free. The turning side is chosen where a spiral is first blocked:
//                left, unless only the right is free. (`bsa`, in contrast, follows its reference side.)
//             2. The constrained inverse distance transform is a wave from the robot over visited cells, stopped at the
//                first one beside an unvisited cell; the robot goes there. Its new spiral begins along visited cells:
//                with a wall or a visited cell on its right, if possible.
//             3. "Map coordinate assignment" turns the grid with the walls: `align = edges`, computed from the map.
//             4. partial = true (needs the map): when a spiral has ended, walls through cells whose centre the robot
//                cannot occupy are followed once, as `bsa` does.
//             5. The lattice has a node at the start. Links are driven with the tool off.
#include "algorithms/grid/spiral_planner.hpp"

namespace oxturn {
namespace {

class LinkedSpirals {
 public:
  LinkedSpirals(CellWalk& walk, WallFollower* walls) : walk_(walk), walls_(walls) {}

  void run() {
    do {
      if (walk_.any_fresh()) choose_heading();
      while (step()) {}
    } while (escape(walk_, walls_, false));
  }

 private:
  /// Along a wall or visited cells, if possible.
  void choose_heading() {
    turns_left_.reset();
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
    if (!turns_left_) turns_left_ = walk_.fresh(left_of(heading_)) || !walk_.fresh(right_of(heading_));
    for (const bool left : {*turns_left_, !*turns_left_}) {
      const Direction d = left ? left_of(heading_) : right_of(heading_);
      if (!walk_.fresh(d) || !walk_.step(d)) continue;
      heading_ = d;
      return true;
    }
    return false;
  }

  CellWalk& walk_;
  WallFollower* walls_;
  Direction heading_ = kEast;
  std::optional<bool> turns_left_;  // the spiral's turning side, once it has been blocked
};

Path plan(const SpiralOptions& options, const Problem& problem, Context& context) {
  return walk_spirals(problem, context, options,
                      [](CellWalk& walk, WallFollower* walls) { LinkedSpirals(walk, walls).run(); });
}

}  // namespace

PlannerInfo linked_spiral() {
  return describe<SpiralOptions, plan>(
      {.name = "linked-spiral",
       .family = "grid",
       .title = "spirals linked by a distance wave",
       .citation = "Choi et al. 2009",
       .capabilities = {Capability::holes, Capability::online},
       .guarantee = "visits every free cell that free lattice edges connect to the start",
       .promise = Promise::cells,
       .symmetries = {Symmetry::shift, Symmetry::scale},
       .parameters = with_spiral_options<SpiralOptions>({}),
       .published = {{"align", "edges"}}});
}

}  // namespace oxturn
