// Explores forwards along the left hand, keeps the cells beside its way for the way back.
//
// Source      after Icking, Kamphans, Klein & Langetepe, "Exploring grid polygons online", arXiv 1012.5240 (CellExplore)
// Model       grid with holes, online (four neighbours felt), disc footprint; comes home
// Guarantee   visits every free cell that free lattice steps join to the start's; from a start at the outer wall at most
//             C + E/2 + 3H + W - 2 moves, the way home included (C cells, E boundary edges, H holes, W sinuosity)
// Complexity  n cells: memory O(n); time O(n) plus, for each cell that it goes back to, the cells nearer than that
// Decisions   1. Forwards: to the first of left, ahead, right that is neither visited nor reserved; the others are
//                reserved, from here. Closed in, it turns back.
//             2. Backwards: to the cell reserved last that is still unvisited (at one place: the one more to the left), by
//                the shortest way over visited cells; from there forwards again, if it can.
//             3. Home at the end. (So told in our words: the paper itself was not at hand. W, its sinuosity, is taken as
//                the reflex corners of the outer wall; the bound is tested on thousands of random polygons with holes,
//                where W was never needed for more than one move.)
//             4. A start away from walls: straight south to one, then as above; the bound is not for that.
//             5. The lattice hangs on the start. Ways over visited cells are driven with the tool off.
#include <algorithm>

#include "algorithms/grid/cell_planner.hpp"
#include "algorithms/lattice/cell_walk.hpp"

namespace oxturn {
namespace {

struct Params {
  double cell_size = 0;
  std::string align = "axes";
  std::string sensing = "map";
};

class CellExploreWalk {
 public:
  explicit CellExploreWalk(CellWalk& walk) : walk_(walk) {}

  void run() {
    const Cell home = walk_.at();
    heading_ = walk_.back_to_wall();
    do forward();
    while (backward() || walk_.escape());  // by lidar ways may have opened later
    walk_.go_to_cell(home);
  }

 private:
  struct Reserved {
    Cell from;
    Direction direction;
    Cell cell() const { return neighbour(from, direction); }
  };

  void forward() {
    while (!walk_.cancelled()) {
      std::optional<Direction> next;
      const std::size_t before = stack_.size();
      for (const Direction d : {left_of(heading_), heading_, right_of(heading_), opposite(heading_)}) {
        if (!walk_.fresh(d) || reserved_.get(neighbour(walk_.at(), d))) continue;
        if (!next)
          next = d;
        else
          stack_.push_back({walk_.at(), d});
      }
      std::reverse(stack_.begin() + static_cast<std::ptrdiff_t>(before), stack_.end());
      for (std::size_t k = before; k < stack_.size(); ++k) reserved_[stack_[k].cell()] = 1;
      if (!next || !walk_.step(*next)) return;
      heading_ = *next;
    }
  }

  // To the cell reserved last.
  bool backward() {
    while (!stack_.empty() && !walk_.cancelled()) {
      const Reserved last = stack_.back();
      stack_.pop_back();
      const Cell cell = last.cell();
      if (walk_.visited(cell)) continue;
      std::optional<Direction> into;
      const bool there = walk_.go_to([&](const Cell& c) {
        for (const Direction d : kAllDirections)
          if (neighbour(c, d) == cell && walk_.open(c, d)) {
            into = d;
            return true;
          }
        return false;
      });
      if (!there || !walk_.step(*into)) continue;
      heading_ = *into;
      return true;
    }
    return false;
  }

  CellWalk& walk_;
  Direction heading_ = kEast;
  CellMap<std::uint8_t> reserved_;
  std::vector<Reserved> stack_;
};

class CellExplore final : public CoveragePlanner {
 public:
  explicit CellExplore(Params p) : p_(std::move(p)) {}
  Path plan(const Problem& problem, Context& context) const override {
    return walk_cells(problem, context, {p_.cell_size, p_.align, p_.sensing}, [&](CellRobot& robot) {
      CellWalk walk(robot, context);
      CellExploreWalk(walk).run();
      walk.report();
    });
  }

 private:
  Params p_;
};

}  // namespace

PlannerInfo cell_explore() {
  return describe<CellExplore, Params>(
      {.name = "cell-explore",
       .family = "grid",
       .title = "exploration that reserves the way back",
       .citation = "Icking et al. 2005",
       .capabilities = {Capability::holes, Capability::online},
       .guarantee = "visits every free cell that free lattice steps join to the start, and comes home",
       .parameters = {
           {"cell_size", &Params::cell_size, Range{0, 1000}, "side of a cell, metres; 0: tool width / sqrt 2"},
           {"align", &Params::align, Choices{"axes", "edges"}, kAlignHelp},
           {"sensing", &Params::sensing, Choices{"map", "lidar"}, kSensingHelp}}});
}

}  // namespace oxturn
