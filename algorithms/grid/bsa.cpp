// Spirals along a reference side, what has been visited counting as obstacle; from their ends back to what is left over.
//
// Source      after Gonzalez, Alvarez, Diaz, Parra & Bustacara, "BSA: a complete coverage algorithm", ICRA 2005
// Model       grid, online (four neighbours felt), disc footprint
// Guarantee   visits every free cell that free lattice steps join to the start's
// Complexity  n cells: memory O(n); time O(n) plus, for each spiral's end, the cells nearer than the next one's start
// Decisions   1. The reference side is chosen at the first contact with a wall: the side that it is on; right, if it is
//                ahead or on both. Until then straight on, east first.
//             2. Then: to the reference side if that is free, else ahead, else away from it; closed in, the spiral ends.
//             3. A new spiral begins with the reference side blocked if that can be.
//             4. Back-track points are the visited cells beside unvisited ones. The source takes the latest
//                (`backtrack = latest`); the nearest by driven way (default) drives a third less among scattered obstacles.
//                The way is the shortest over visited cells, driven with the tool off.
//             5. partial = true (the paper's extension, by map only): where the reference side or what is ahead is a cell
//                that the robot cannot stand in the middle of, it first follows the wall through it and on, and comes back
//                over the free cells beside (wall_follower.hpp). Cells beside walls that are still unfollowed are
//                back-track points then.
//             6. The lattice hangs on the start.
#include <string>
#include <vector>

#include "algorithms/grid/cell_planner.hpp"
#include "algorithms/lattice/cell_walk.hpp"
#include "algorithms/grid/wall_follower.hpp"

namespace oxturn {
namespace {

struct Params {
  double cell_size = 0;
  std::string backtrack = "nearest";
  bool partial = false;
  std::string align = "axes";
  std::string sensing = "map";
};

class Spirals {
 public:
  Spirals(CellWalk& walk, bool latest, WallFollower* walls) : walk_(walk), latest_(latest), walls_(walls) {}

  void run() {
    do spiral();
    while (back_track());
  }

 private:
  Direction reference() const { return left_ ? left_of(heading_) : right_of(heading_); }

  // One spiral, until the robot is closed in.
  void spiral() {
    if (!walk_.any_fresh()) return;
    begin();
    while (!walk_.cancelled()) {
      if (!chosen_) choose_side();
      if (walls_ && chosen_)
        for (const Direction d : {reference(), heading_})
          if (!walk_.open(d))
            for (const Cell& c : {neighbour(walk_.at(), d), walk_.at()}) walls_->follow(walk_, c, left_);
      const Direction side = reference(), away = opposite(side);
      Direction next;
      if (chosen_ && walk_.fresh(side))
        next = side;
      else if (walk_.fresh(heading_))
        next = heading_;
      else if (walk_.fresh(away))
        next = away;
      else
        return;
      remember(next);
      if (!walk_.step(next)) continue;
      heading_ = next;
    }
  }

  // The robot may face anywhere: with the reference side blocked if that can be, else ahead if that is free.
  void begin() {
    for (int turn = 0; turn < 4; ++turn) {
      if (walk_.fresh(heading_) && !walk_.fresh(reference())) return;
      heading_ = left_ ? right_of(heading_) : left_of(heading_);
    }
    while (!walk_.fresh(heading_)) heading_ = left_of(heading_);
  }

  void choose_side() {
    if (!walk_.fresh(right_of(heading_)) || !walk_.fresh(heading_))
      left_ = false;
    else if (!walk_.fresh(left_of(heading_)))
      left_ = true;
    else
      return;
    chosen_ = true;
  }

  void remember(Direction next) {
    if (!latest_) return;
    for (const Direction d : kAllDirections)
      if (d != next && walk_.fresh(d)) {
        points_.push_back(walk_.at());
        return;
      }
  }

  bool back_track() {
    if (walk_.cancelled()) return false;
    while (latest_ && !points_.empty()) {
      const Cell point = points_.back();
      points_.pop_back();
      if (walk_.any_fresh(point) && walk_.go_to_cell(point)) return true;
    }
    if (!walls_) return walk_.escape();
    const auto left_over = [&](const Cell& c) { return walk_.any_fresh(c) || walls_->any_left(c); };
    while (walk_.go_to(left_over)) {
      walls_->follow_all(walk_, left_);
      if (walk_.any_fresh()) return true;
    }
    return false;
  }

  CellWalk& walk_;
  bool latest_;
  WallFollower* walls_;
  Direction heading_ = kEast;
  bool left_ = false, chosen_ = false;
  std::vector<Cell> points_;
};

class Bsa final : public CoveragePlanner {
 public:
  explicit Bsa(Params p) : p_(std::move(p)) {}
  Path plan(const Problem& problem, Context& context) const override {
    return walk_cells(problem, context, {p_.cell_size, p_.align, p_.sensing, 1, false, p_.partial},
                      [&](CellRobot& robot) {
                        CellWalk walk(robot, context);
                        std::optional<WallFollower> walls;
                        if (p_.partial) walls.emplace(problem, robot);
                        Spirals(walk, p_.backtrack == "latest", walls ? &*walls : nullptr).run();
                        if (walls) context.record("along_walls_m", walls->length());
                        walk.report();
                      });
  }

 private:
  Params p_;
};

}  // namespace

PlannerInfo bsa() {
  return describe<Bsa, Params>(
      {.name = "bsa",
       .family = "grid",
       .title = "backtracking spirals",
       .citation = "Gonzalez et al. 2005",
       .capabilities = {Capability::holes, Capability::online},
       .guarantee = "visits every free cell that free lattice steps join to the start",
       .parameters = {
           {"cell_size", &Params::cell_size, Range{0, 1000}, "side of a cell, metres; 0: tool width / sqrt 2"},
           {"backtrack", &Params::backtrack, Choices{"nearest", "latest"}, "where to go when a spiral has ended"},
           {"partial", &Params::partial, "follow walls through cells that are not wholly free (sensing = map)"},
           {"align", &Params::align, Choices{"axes", "edges"}, kAlignHelp},
           {"sensing", &Params::sensing, Choices{"map", "lidar"}, kSensingHelp}}});
}

}  // namespace oxturn
