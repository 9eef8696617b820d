// Back-and-forth lanes; where one is closed in, the shortest way to the best back-track point.
//
// Source      after Viet, Dang, Laskar & Chung, "BA*: an online complete coverage algorithm for cleaning robots",
//             Applied Intelligence 39 (2013)
// Model       grid, online (four neighbours felt), disc footprint
// Guarantee   visits every free cell that free lattice steps join to the start's
// Complexity  n cells: memory O(n); time O(n) plus, for each lane system's end, the cells nearer than the next start
// Decisions   1. Lanes: to the first of north, south, east, west that is free and unvisited.
//             2. A visited cell is a back-track point if the next lanes can begin beside it in a corner of what is left:
//                an unvisited neighbour east, west or south, of which a neighbour across is a wall or visited (the
//                paper's six pairs; north is never left over, for it comes first). Diagonal cells count as walls when the
//                cell between cannot be driven to.
//             3. "Best" is the shortest way. All steps cost the same, so breadth-first finds what A* would, without
//                asking for each point of the list. If none of eight times the cells about the nearest other cell beside
//                an unvisited one is a back-track point (thin walls), that one is taken.
//             4. The way is smoothed (`smooth = true`): from each cell straight to the farthest that can be, over squares
//                between cells that no wall comes into.
//             5. The lattice hangs on the start; the robot feels the diagonal cells as well.
//             6. Ways over visited cells are driven with the tool off.
#include "algorithms/grid/cell_planner.hpp"
#include "algorithms/lattice/cell_walk.hpp"

namespace oxturn {
namespace {

struct Params {
  double cell_size = 0;
  bool smooth = true;
  std::string align = "axes";
  std::string sensing = "map";
};

class LanesAndPoints {
 public:
  LanesAndPoints(CellWalk& walk, bool smooth) : walk_(walk), smooth_(smooth) {}

  void run() {
    do {
      feel_corners();
      while (step()) feel_corners();
    } while (to_best_point());
  }

 private:
  static constexpr std::size_t kFarther = 8, kAtLeast = 64;

  bool step() {
    if (walk_.cancelled()) return false;
    for (const Direction d : {kNorth, kSouth, kEast, kWest})
      if (walk_.fresh(d) && walk_.step(d)) return true;
    return false;
  }

  // Of the ways "one step in d, then one across": a bit for each that is open, d being unvisited yet.
  void feel_corners() {
    std::uint8_t corners = 0;
    for (const Direction d : {kEast, kWest, kSouth}) {
      if (!walk_.fresh(d)) continue;
      const Cell beside = neighbour(walk_.at(), d);
      if (walk_.robot().passable(beside, left_of(d))) corners |= static_cast<std::uint8_t>(1 << 2 * d);
      if (walk_.robot().passable(beside, right_of(d))) corners |= static_cast<std::uint8_t>(2 << 2 * d);
    }
    if (corners != 0) corners_[walk_.at()] = corners;
  }

  bool back_track_point(const Cell& c) const {
    const std::uint8_t corners = corners_.get(c);
    for (const Direction d : {kEast, kWest, kSouth}) {
      if (!walk_.fresh(c, d)) continue;
      const Cell beside = neighbour(c, d);
      for (const int side : {0, 1}) {
        const Direction across = side == 0 ? left_of(d) : right_of(d);
        if (!(corners >> (2 * d + side) & 1) || walk_.visited(neighbour(beside, across))) return true;
      }
    }
    return false;
  }

  bool to_best_point() {
    while (!walk_.cancelled()) {
      std::size_t looked = 0, enough = 0;
      std::optional<Cell> other;
      bool best = false;
      auto way = walk_.path_to([&](const Cell& c) {
        ++looked;
        if (!walk_.any_fresh(c)) return other && looked > enough;
        best = back_track_point(c);
        if (best) return true;
        if (!other) {
          other = c;
          enough = kFarther * looked + kAtLeast;
        }
        return looked > enough;
      });
      if (!best && !other) return walk_.escape();  // for what has been learnt since
      if (!best) way = walk_.path_to_cell(*other);
      if (walk_.walk(*way, false, smooth_)) return true;
    }
    return false;
  }

  CellWalk& walk_;
  bool smooth_;
  CellMap<std::uint8_t> corners_;
};

class BaStar final : public CoveragePlanner {
 public:
  explicit BaStar(Params p) : p_(std::move(p)) {}
  Path plan(const Problem& problem, Context& context) const override {
    return walk_cells(problem, context, {p_.cell_size, p_.align, p_.sensing, 1, p_.smooth}, [&](CellRobot& robot) {
      CellWalk walk(robot, context);
      LanesAndPoints(walk, p_.smooth).run();
      walk.report();
    });
  }

 private:
  Params p_;
};

}  // namespace

PlannerInfo ba_star() {
  return describe<BaStar, Params>(
      {.name = "ba-star",
       .family = "grid",
       .title = "back-and-forth lanes with A* to back-track points",
       .citation = "Viet et al. 2013",
       .capabilities = {Capability::holes, Capability::online},
       .guarantee = "visits every free cell that free lattice steps join to the start",
       .parameters = {
           {"cell_size", &Params::cell_size, Range{0, 1000}, "side of a cell, metres; 0: tool width / sqrt 2"},
           {"smooth", &Params::smooth, "ways to back-track points leave the lattice where that is shorter"},
           {"align", &Params::align, Choices{"axes", "edges"}, kAlignHelp},
           {"sensing", &Params::sensing, Choices{"map", "lidar"}, kSensingHelp}}});
}

}  // namespace oxturn
