// Spirals along a reference side, visited cells counting as obstacles; from their ends back to what is still unvisited.
//
// Source      after Gonzalez, Alvarez, Diaz, Parra & Bustacara, "BSA: a complete coverage algorithm", ICRA 2005
// Model       grid, online (four neighbours felt), disc footprint
// Guarantee   visits every free cell that free lattice edges connect to the start's
// Complexity  n cells: memory O(n); time O(n) plus, for each spiral's end, the cells nearer than the next one's start
// Decisions   1. The reference side is chosen at the first contact with a wall: the side of the wall; right if the wall
//                is ahead or on both sides. Until then straight on, east first.
//             2. Afterwards: to the reference side if that is free, else ahead, else to the other side. Closed in, the
//                spiral ends.
//             3. A new spiral begins with the reference side blocked, if possible.
//             4. Backtracking points are visited cells beside unvisited ones. The source takes the latest
//                (`backtrack = latest`); the nearest by driven path (our default) drives a third less among scattered
//                obstacles. The path has the fewest steps over visited cells and is driven with the tool off.
//             5. partial = true (the paper's extension; needs the map): where the reference side or the cell ahead is
//                one whose centre the robot cannot occupy, it first follows the wall through that cell and beyond, and
//                comes back over the free cells beside (wall_follower.hpp). Cells beside unfollowed walls are
//                backtracking points then.
//             6. The lattice has a node at the start.
#include <vector>

#include "algorithms/grid/spiral_planner.hpp"

namespace oxturn {
namespace {

enum class Backtrack { nearest, latest };

struct Params : SpiralOptions {
  Backtrack backtrack = Backtrack::nearest;
};

class Spirals {
 public:
  Spirals(CellWalk& walk, WallFollower* walls, Backtrack backtrack)
      : walk_(walk), walls_(walls), backtrack_(backtrack) {}

  void run() {
    do spiral();
    while (back_track());
  }

 private:
  Direction reference() const { return left_ ? left_of(heading_) : right_of(heading_); }

  /// One spiral, until the robot is closed in.
  void spiral() {
    if (!walk_.any_fresh()) return;
    choose_heading();
    while (!walk_.cancelled()) {
      if (!side_chosen_) choose_side();
      if (walls_ && side_chosen_) follow_walls();
      const std::optional<Direction> next = next_step();
      if (!next) return;
      remember_other_than(*next);
      if (walk_.step(*next)) heading_ = *next;
    }
  }

  /// With the reference side blocked if possible, else any free direction.
  void choose_heading() {
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
    side_chosen_ = true;
  }

  void follow_walls() {
    for (const Direction d : {reference(), heading_}) {
      if (walk_.open(d)) continue;
      for (const Cell& c : {neighbour(walk_.at(), d), walk_.at()}) walls_->follow(walk_, c, left_);
    }
  }

  std::optional<Direction> next_step() const {
    if (side_chosen_ && walk_.fresh(reference())) return reference();
    for (const Direction d : {heading_, opposite(reference())})
      if (walk_.fresh(d)) return d;
    return std::nullopt;
  }

  void remember_other_than(Direction next) {
    if (backtrack_ != Backtrack::latest) return;
    for (const Direction d : kAllDirections)
      if (d != next && walk_.fresh(d)) {
        points_.push_back(walk_.at());
        return;
      }
  }

  bool back_track() {
    if (walk_.cancelled()) return false;
    while (!points_.empty()) {
      const Cell point = points_.back();
      points_.pop_back();
      if (walk_.any_fresh(point) && walk_.go_to_cell(point)) return true;
    }
    return escape(walk_, walls_, left_);
  }

  CellWalk& walk_;
  WallFollower* walls_;
  Backtrack backtrack_;
  Direction heading_ = kEast;
  bool left_ = false, side_chosen_ = false;  // the reference side
  std::vector<Cell> points_;                 // to go back to, for Backtrack::latest
};

Path plan(const Params& p, const Problem& problem, Context& context) {
  return walk_spirals(problem, context, p,
                      [&](CellWalk& walk, WallFollower* walls) { Spirals(walk, walls, p.backtrack).run(); });
}

}  // namespace

PlannerInfo bsa() {
  return describe<Params, plan>(
      {.name = "bsa",
       .family = "grid",
       .title = "backtracking spirals",
       .citation = "Gonzalez et al. 2005",
       .capabilities = {Capability::holes, Capability::online},
       .guarantee = "visits every free cell that free lattice edges connect to the start",
       .promise = Promise::cells,
       .symmetries = {Symmetry::shift, Symmetry::scale},
       .parameters = with_spiral_options<Params>(
           {{"backtrack", &Params::backtrack, Choices{"nearest", "latest"}, "where to go when a spiral has ended"}}),
       .published = {{"backtrack", "latest"}}});
}

}  // namespace oxturn
