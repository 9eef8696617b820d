#include <string>
#include <vector>

#include "algorithms/grid/cell_planner.hpp"
#include "algorithms/grid/cell_walk.hpp"

namespace oxturn {
namespace {

struct Params {
  double cell_size = 0;
  std::string backtrack = "nearest";
  std::string align = "axes";
  std::string sensing = "map";
};

class Spirals {
 public:
  Spirals(CellWalk& walk, bool latest) : walk_(walk), latest_(latest) {}

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
      if (walk_.any_fresh(point) && walk_.go_to([&](const Cell& c) { return c == point; })) return true;
    }
    return walk_.escape();
  }

  CellWalk& walk_;
  bool latest_;
  Direction heading_ = kEast;
  bool left_ = false, chosen_ = false;
  std::vector<Cell> points_;
};

class Bsa final : public CoveragePlanner {
 public:
  explicit Bsa(Params p) : p_(std::move(p)) {}
  Path plan(const Problem& problem, Context& context) const override {
    return walk_cells(problem, context, {p_.cell_size, p_.align, p_.sensing}, [&](CellRobot& robot) {
      CellWalk walk(robot, context);
      Spirals(walk, p_.backtrack == "latest").run();
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
           {"align", &Params::align, Choices{"axes", "edges"}, kAlignHelp},
           {"sensing", &Params::sensing, Choices{"map", "lidar"}, kSensingHelp}}});
}

}  // namespace oxturn
