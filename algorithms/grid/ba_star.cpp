// Back-and-forth lanes; where one ends closed in, a shortest path to the best backtracking point.
//
// Source      after Viet, Dang, Laskar & Chung, "BA*: an online complete coverage algorithm for cleaning robots",
//             Applied Intelligence 39 (2013)
// Model       grid, online (four neighbours felt), disc footprint
// Guarantee   visits every free cell that free lattice edges connect to the start's
// Complexity  n cells: memory O(n); time O(n) plus, for each end of a lane system, the cells nearer than the next start
// Decisions   1. Lanes: to the first of north, south, east, west that is free and unvisited.
//             2. A visited cell is a backtracking point if the next lanes can begin beside it in a corner of the
//                unvisited cells: it has an unvisited neighbour east, west or south, one of whose lateral neighbours is
//                a wall or visited. (These are the paper's six pairs. North is never left over, because it comes
//                first.) A diagonal cell counts as a wall if it cannot be reached from the cell between.
//             3. The best point is the one at the end of the shortest path. All steps cost the same, so one
//                breadth-first search finds what A* to each point would. If no backtracking point is among the first
//                eight times as many cells as were searched up to the nearest other cell beside an unvisited one (thin
//                walls), that cell is taken.
//             4. The path is smoothed (`smooth = true`): from each cell straight to the farthest possible, across
//                squares between cells that no wall enters.
//             5. The lattice has a node at the start; the robot feels the diagonal cells as well.
//             6. Paths over visited cells are driven with the tool off.
#include "algorithms/grid/cell_planner.hpp"

namespace oxturn {
namespace {

struct Params : CellOptions {
  bool smooth = true;
};

class LanesAndPoints {
 public:
  LanesAndPoints(CellWalk& walk, bool smooth) : walk_(walk), smooth_(smooth) {}

  void run() {
    do {
      feel_corners();
      while (step()) feel_corners();
    } while (go_to_best_point());
  }

 private:
  // How much farther than to the nearest candidate a backtracking point is searched, in cells: decision 3.
  static constexpr std::size_t kFarther = 8, kAtLeast = 64;
  /// Two sets of directions d: after an unvisited step in d, a step to the left (right) is open.
  struct Corners {
    std::uint8_t left : 4 = 0, right : 4 = 0;
  };

  bool step() {
    if (walk_.cancelled()) return false;
    for (const Direction d : {kNorth, kSouth, kEast, kWest})
      if (walk_.fresh(d) && walk_.step(d)) return true;
    return false;
  }

  void feel_corners() {
    Corners corners;
    for (const Direction d : {kEast, kWest, kSouth}) {
      if (!walk_.fresh(d)) continue;
      const Cell beside = neighbour(walk_.at(), d);
      if (walk_.robot().passable(beside, left_of(d))) corners.left |= 1 << d;
      if (walk_.robot().passable(beside, right_of(d))) corners.right |= 1 << d;
    }
    if (corners.left != 0 || corners.right != 0) corners_[walk_.at()] = corners;
  }

  bool is_backtracking_point(const Cell& c) const {
    const Corners corners = corners_.get(c);
    for (const Direction d : {kEast, kWest, kSouth}) {
      if (!walk_.fresh(c, d)) continue;
      const Cell beside = neighbour(c, d);
      if (!(corners.left >> d & 1) || walk_.visited(neighbour(beside, left_of(d)))) return true;
      if (!(corners.right >> d & 1) || walk_.visited(neighbour(beside, right_of(d)))) return true;
    }
    return false;
  }

  bool go_to_best_point() {
    while (!walk_.cancelled()) {
      std::size_t searched = 0, enough = 0;
      std::optional<Cell> other;  // the nearest cell beside an unvisited one
      bool found = false;
      auto path = walk_.path_to([&](const Cell& c) {
        ++searched;
        if (!walk_.any_fresh(c)) return other && searched > enough;
        found = is_backtracking_point(c);
        if (found) return true;
        if (!other) {
          other = c;
          enough = kFarther * searched + kAtLeast;
        }
        return searched > enough;
      });
      if (!found && !other) return walk_.escape();  // by lidar, steps may have opened since
      if (!found) path = walk_.path_to_cell(*other);
      if (smooth_ ? walk_.follow_smoothed(*path) : walk_.follow(*path)) return true;
    }
    return false;
  }

  CellWalk& walk_;
  bool smooth_;
  CellMap<Corners> corners_;
};

Path plan(const Params& p, const Problem& problem, Context& context) {
  return walk_cells(problem, context, p, {.diagonals = p.smooth},
                    [&](CellWalk& walk) { LanesAndPoints(walk, p.smooth).run(); });
}

}  // namespace

PlannerInfo ba_star() {
  return describe<Params, plan>(
      {.name = "ba-star",
       .family = "grid",
       .title = "back-and-forth lanes with A* to backtracking points",
       .citation = "Viet et al. 2013",
       .capabilities = {Capability::holes, Capability::online},
       .guarantee = "visits every free cell that free lattice edges connect to the start",
       .promise = Promise::cells,
       .symmetries = {Symmetry::shift, Symmetry::scale},
       .parameters = with_cell_options<Params>(
           {{"smooth", &Params::smooth, "paths to backtracking points leave the lattice where that is shorter"}})});
}

}  // namespace oxturn
