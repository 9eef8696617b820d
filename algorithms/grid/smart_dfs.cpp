// Depth-first exploration that walks the short way back, and at a split finishes first what lies off its way home.
//
// Source      after Icking, Kamphans, Klein & Langetepe, "Exploring simple grid polygons", COCOON 2005 (SmartDFS); the
//             same authors' "Exploring grid polygons online", arXiv 1012.5240
// Model       grid, online (the eight cells about the robot felt), disc footprint; comes home
// Guarantee   visits every free cell that free lattice steps join to the start's; without holes and from a start at the
//             wall at most C + E/2 - 3 moves (C cells, E boundary edges), the way home included
// Complexity  n cells: memory O(n); time O(n) plus, for each return, the cells nearer than where it goes
// Decisions   1. Left-hand rule: left, ahead, right of the direction in which a cell was entered first; back to it only
//                when something is left there, over visited cells by the shortest way.
//             2. A cell's layer is one more than the least among its eight neighbours, walls being layer 0: of those that
//                are walls or visited when the robot comes.
//             3. A cell is a split cell if its unvisited neighbours do not hang together about it: what lies between two of
//                them (the cell across the corner, or ahead if they are left and right) is a wall or visited. Each part
//                then has a boundary on its left and one on its right: at the far left the layer outside, at the far
//                right the robot's own layer, else what lies between. A part with its own layer on one side only is
//                partially surrounded (the paper's type III) and is visited last; if there is none, the left-hand rule
//                with its first step left for the end. (So told in our words: the paper's figures were not at hand; the
//                bound is tested on thousands of random polygons, and fails without this rule.)
//             4. A start away from walls: straight south to one, then as above; the bound is not for that.
//             5. The lattice hangs on the start. Ways over visited cells are driven with the tool off.
#include <algorithm>
#include <array>

#include "algorithms/grid/cell_planner.hpp"
#include "algorithms/lattice/cell_walk.hpp"

namespace oxturn {
namespace {

struct Params {
  double cell_size = 0;
  std::string align = "axes";
  std::string sensing = "map";
};

class SmartDfsWalk {
 public:
  explicit SmartDfsWalk(CellWalk& walk) : walk_(walk) {}

  void run() {
    const Cell home = walk_.at();
    enter(walk_.back_to_wall());
    while (!stack_.empty() && !walk_.cancelled()) {
      Visit& visit = stack_.back();
      if (visit.next == visit.count) {
        stack_.pop_back();
        continue;
      }
      const Direction d = visit.order[visit.next++];
      const Cell base = visit.cell;
      if (walk_.fresh(base, d) && walk_.go_to_cell(base) && walk_.fresh(d) && walk_.step(d)) enter(d);
    }
    // By lidar: ways that opened later.
    while (walk_.escape())
      for (const Direction d : kAllDirections)
        if (walk_.fresh(d)) walk_.step(d);
    walk_.go_to_cell(home);
  }

 private:
  struct Visit {
    Cell cell;
    std::array<Direction, 3> order;
    std::uint8_t count = 0, next = 0;
  };

  /// Of a cell beside the robot's: 0 for a wall, nothing if it is free and unvisited.
  std::optional<std::uint32_t> layer_of(const Cell& c) const {
    if (walk_.visited(c)) return layers_.get(c);
    if (!walk_.robot().free(c)) return 0;
    return std::nullopt;
  }

  std::uint32_t layer_here() const {
    const Cell at = walk_.at();
    std::uint32_t least = 0xffffffff;
    for (int di = -1; di <= 1; ++di)
      for (int dj = -1; dj <= 1; ++dj)
        if (di != 0 || dj != 0)
          if (const auto layer = layer_of({at.i + di, at.j + dj})) least = std::min(least, *layer + 1);
    return least;
  }

  void enter(Direction heading) {
    const Cell at = walk_.at();
    const std::uint32_t layer = layers_[at] = layer_here();
    Visit visit{at, {}, 0, 0};
    std::array<std::uint8_t, 3> part{0, 0, 0};            // of each direction in the order
    std::array<bool, 4> own{false, false, false, false};  // of each part's left side: of the robot's own layer
    std::uint8_t last = 0;
    for (const Direction d : {left_of(heading), heading, right_of(heading)}) {
      if (!walk_.fresh(d)) continue;
      if (visit.count > 0) {
        const Direction before = visit.order[visit.count - 1u];
        const Cell between = before == left_of(d) ? neighbour(neighbour(at, before), d) : neighbour(at, heading);
        if (const auto there = layer_of(between)) own[++last] = *there == layer;
      }
      part[visit.count] = last;
      visit.order[visit.count++] = d;
    }
    own[last + 1u] = true;
    if (last > 0) reorder(visit, part, own);
    stack_.push_back(visit);
  }

  static void reorder(Visit& visit, const std::array<std::uint8_t, 3>& part, const std::array<bool, 4>& own) {
    std::array<Direction, 3> order{};
    std::size_t n = 0;
    const auto take = [&](bool surrounded_partially) {
      for (std::size_t k = 0; k < visit.count; ++k)
        if ((own[part[k]] != own[part[k] + 1u]) == surrounded_partially) order[n++] = visit.order[k];
    };
    take(false);
    if (n == visit.count) {
      std::rotate(visit.order.begin(), visit.order.begin() + 1, visit.order.begin() + visit.count);
      return;
    }
    take(true);
    visit.order = order;
  }

  CellWalk& walk_;
  CellMap<std::uint32_t> layers_;
  std::vector<Visit> stack_;
};

class SmartDfs final : public CoveragePlanner {
 public:
  explicit SmartDfs(Params p) : p_(std::move(p)) {}
  Path plan(const Problem& problem, Context& context) const override {
    return walk_cells(problem, context, {p_.cell_size, p_.align, p_.sensing}, [&](CellRobot& robot) {
      CellWalk walk(robot, context);
      SmartDfsWalk(walk).run();
      walk.report();
    });
  }

 private:
  Params p_;
};

}  // namespace

PlannerInfo smart_dfs() {
  return describe<SmartDfs, Params>(
      {.name = "smart-dfs",
       .family = "grid",
       .title = "depth-first exploration with split cells",
       .citation = "Icking et al. 2005",
       .capabilities = {Capability::holes, Capability::online},
       .guarantee = "visits every free cell that free lattice steps join to the start, and comes home",
       .parameters = {
           {"cell_size", &Params::cell_size, Range{0, 1000}, "side of a cell, metres; 0: tool width / sqrt 2"},
           {"align", &Params::align, Choices{"axes", "edges"}, kAlignHelp},
           {"sensing", &Params::sensing, Choices{"map", "lidar"}, kSensingHelp}}});
}

}  // namespace oxturn
