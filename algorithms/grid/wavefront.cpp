// Climbs a distance transform: the far cells first, down to the goal last.
//
// Source      after Zelinsky, Jarvis, Byrne & Yuta, "Planning paths of complete coverage of an unstructured environment by
//             a mobile robot", ICAR 1993
// Model       grid with eight neighbours, offline, disc footprint
// Guarantee   stop = backtrack: visits every free cell that is joined to the first one by free steps; with components =
//             all every free cell. stop = closed (the source): only until it is closed in
// Complexity  n cells: memory O(n); time O(n) plus, for each time that it is closed in, the cells nearer than the next
//             unvisited one; transform = path costs O(n log n) more
// Decisions   1. The wave spreads from the goal to all eight neighbours by steps of one. A problem has no goal: it is the
//                start's cell, or with `goal = farthest` the cell farthest from it.
//             2. Diagonal steps where the straight way is in configuration space, exactly as for the others.
//             3. Of the unvisited neighbours with the highest value: the one with the least turn, then the left one.
//             4. The source stops when closed in. `stop = backtrack` (ours, default) goes on to the nearest unvisited cell,
//                breadth-first over visited ones, with the tool off.
//             5. transform = path (Zelinsky's path transform): a step costs 1 plus `discomfort` times the closeness of the
//                cell to walls, 3, 2, 1 for the first three cells away from one, else 0. So it follows the walls' shape.
//             6. components = all (ours) goes on to the parts that no lattice step leads to, nearest first, by shortest
//                paths; each has a wave of its own, from where it is entered.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <queue>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lattice/cell_robot.hpp"
#include "algorithms/transit/nearest_component.hpp"

namespace oxturn {
namespace {

struct Params {
  double cell_size = 0;
  std::string stop = "backtrack";
  std::string transform = "distance";
  double discomfort = 2;
  std::string goal = "start";
  std::string components = "all";
  std::string align = "axes";
  double shift_x = 0, shift_y = 0;
};

// The eight directions, counter-clockwise from east.
constexpr std::array<int, 8> kStepColumn{1, 1, 0, -1, -1, -1, 0, 1}, kStepRow{0, 1, 1, 1, 0, -1, -1, -1};

class Climb {
 public:
  static constexpr std::uint32_t kNever = 0xffffffff;

  Climb(const Params& p, const GridGraph& graph, Context& context)
      : p_(p),
        graph_(graph),
        context_(context),
        open_(graph.size(), 0),
        height_(graph.size(), kNever),
        found_(graph.size(), 0) {
    for (std::size_t d = 0; d < 8; ++d) step_[d] = kStepColumn[d] + std::ptrdiff_t{kStepRow[d]} * graph.columns();
    for (int j = 0; j < graph.rows(); ++j)
      for (int i = 0; i < graph.columns(); ++i)
        for (std::size_t d = 0; d < 8; ++d)
          if (d % 2 == 0 ? graph.passable(i, j, static_cast<Direction>(d / 2))
                         : graph.diagonal(i, j, kStepColumn[d], kStepRow[d]))
            open_[graph.at(i, j)] |= static_cast<std::uint8_t>(1 << d);
  }

  bool visited(std::size_t c) const { return (found_[c] & kVisited) != 0; }
  bool cancelled() {
    if (!cancelled_ && ++asked_ % 256 == 0) cancelled_ = context_.cancelled();
    return cancelled_;
  }
  std::size_t cells() const { return cells_; }

  /// From cell c, where the path ends.
  void cover_part(std::size_t c, PathBuilder& path) {
    std::size_t goal = c;
    spread(goal);
    if (p_.goal == "farthest") {
      goal = queue_.back();
      for (const std::size_t k : queue_) height_[k] = kNever;
      spread(goal);
    }
    if (p_.transform == "path") add_discomfort(goal);
    walk(c, path);
  }

 private:
  static constexpr std::uint32_t kVisited = 1u << 31, kLastStamp = (1u << 28) - 1;

  std::size_t neighbour(std::size_t c, std::size_t d) const {
    return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(c) + step_[d]);
  }
  template <class F>
  void for_each_neighbour(std::size_t c, F f) const {
    for (unsigned open = open_[c]; open != 0; open &= open - 1) {
      const auto d = static_cast<std::size_t>(std::countr_zero(open));
      f(d, neighbour(c, d));
    }
  }

  void spread(std::size_t from) {
    queue_.assign(1, from);
    height_[from] = 0;
    for (std::size_t k = 0; k < queue_.size(); ++k)
      for_each_neighbour(queue_[k], [&](std::size_t, std::size_t to) {
        if (height_[to] != kNever) return;
        height_[to] = height_[queue_[k]] + 1;
        queue_.push_back(to);
      });
  }

  /// Cells from a wall: 3, 2, 1, else 0.
  std::vector<std::uint8_t> closeness() const {
    std::vector<std::uint8_t> close(graph_.size(), 0);
    std::vector<std::size_t> rim, next;
    for (const std::size_t c : queue_)
      if (open_[c] != 0xff) rim.push_back(c);
    for (std::uint8_t value = 3; value > 0; --value) {
      next.clear();
      for (const std::size_t c : rim) close[c] = value;
      for (const std::size_t c : rim)
        for_each_neighbour(c, [&](std::size_t, std::size_t to) {
          if (close[to] != 0) return;
          close[to] = 0xff;
          next.push_back(to);
        });
      rim.swap(next);
    }
    for (const std::size_t c : rim) close[c] = 0;
    return close;
  }

  // Dijkstra; costs in hundredths, so that equal heights are equal. Keeps the order of `queue_`.
  void add_discomfort(std::size_t goal) {
    const std::vector<std::uint8_t> close = closeness();
    for (const std::size_t c : queue_) height_[c] = kNever;
    using Item = std::pair<std::uint32_t, std::size_t>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> open;
    height_[goal] = 0;
    open.push({0, goal});
    const auto unit = static_cast<std::uint32_t>(std::lround(100 * p_.discomfort));
    while (!open.empty()) {
      const auto [height, c] = open.top();
      open.pop();
      if (height != height_[c]) continue;
      for_each_neighbour(c, [&, h = height](std::size_t, std::size_t to) {
        const std::uint32_t there = h + 100 + unit * close[to];
        if (there >= height_[to]) return;
        height_[to] = there;
        open.push({there, to});
      });
    }
  }

  void visit(std::size_t c) {
    if (!visited(c)) ++cells_;
    found_[c] |= kVisited;
  }

  void walk(std::size_t c, PathBuilder& path) {
    std::size_t heading = 0;
    visit(c);
    while (!cancelled()) {
      for (auto next = highest(c, heading); next; next = highest(c, heading)) {
        if (*next != heading) path.drive(centre(c), true);  // straight runs are one segment
        heading = *next;
        c = neighbour(c, heading);
        visit(c);
        if (cancelled()) break;
      }
      path.drive(centre(c), true);
      if (p_.stop == "closed") return;
      const auto way = path_out(c);
      if (!way) return;
      for (const std::size_t k : *way) path.drive(centre(k), false);
      if (!way->empty()) c = way->back();
    }
  }

  std::optional<std::size_t> highest(std::size_t c, std::size_t heading) const {
    static constexpr std::array<std::size_t, 8> kTurns{0, 1, 7, 2, 6, 3, 5, 4};
    std::optional<std::size_t> best;
    std::uint32_t height = 0;
    for (const std::size_t turn : kTurns) {
      const std::size_t d = (heading + turn) % 8;
      if (!(open_[c] >> d & 1)) continue;
      const std::size_t to = neighbour(c, d);
      if (visited(to) || (best && height_[to] <= height)) continue;
      best = d;
      height = height_[to];
    }
    return best;
  }

  // To the nearest visited cell beside an unvisited one; stamped marks, with the direction the search came by.
  std::optional<std::vector<std::size_t>> path_out(std::size_t from) {
    if (++stamp_ > kLastStamp) {
      for (std::uint32_t& f : found_) f &= kVisited;
      stamp_ = 1;
    }
    queue_.assign(1, from);
    found_[from] = kVisited | stamp_ << 3;
    for (std::size_t k = 0; k < queue_.size(); ++k) {
      const std::size_t c = queue_[k];
      bool out = false;
      for_each_neighbour(c, [&](std::size_t d, std::size_t to) {
        if (!visited(to)) out = true;
        if (!visited(to) || (found_[to] & ~kVisited) >> 3 == stamp_) return;
        found_[to] = kVisited | stamp_ << 3 | static_cast<std::uint32_t>(d);
        queue_.push_back(to);
      });
      if (!out) continue;
      std::vector<std::size_t> way;
      for (std::size_t at = c; at != from;) {
        way.push_back(at);
        at = neighbour(at, (found_[at] + 4) & 7);  // back
      }
      std::reverse(way.begin(), way.end());
      return way;
    }
    return std::nullopt;
  }
  Point centre(std::size_t c) const {
    const auto columns = static_cast<std::size_t>(graph_.columns());
    return graph_.centre(static_cast<double>(c % columns), static_cast<double>(c / columns));
  }

  const Params& p_;
  const GridGraph& graph_;
  Context& context_;
  std::vector<std::uint8_t> open_;  // directions, a bit each
  std::array<std::ptrdiff_t, 8> step_;
  std::vector<std::uint32_t> height_, found_;
  std::vector<std::size_t> queue_;
  std::uint32_t stamp_ = 0;
  std::size_t cells_ = 0, asked_ = 0;
  bool cancelled_ = false;
};

class Wavefront final : public CoveragePlanner {
 public:
  explicit Wavefront(Params p) : p_(std::move(p)) {}

  Path plan(const Problem& problem, Context& context) const override {
    const double side = cell_side(p_.cell_size, problem.robot());
    GridGraph graph = make_grid_graph(problem, {p_.cell_size, p_.align, p_.shift_x, p_.shift_y}, side, 1);
    graph.look_between(problem.configuration_space());
    const std::optional<Entry> entry = entry_from_start(problem, graph);
    if (!entry) throw Infeasible("no cell's centre is free; a smaller cell_size, or a shift of the grid, may help");
    PathBuilder path(problem.start());
    // The last cell of a part may be its only one: the tool is on when the robot comes there.
    path.drive(entry->way, true);
    Climb climb(p_, graph, context);
    climb.cover_part(graph.at(entry->column, entry->row), path);
    if (p_.components == "all" && p_.stop == "backtrack") cover_others(problem, graph, climb, path);
    context.record("cells", static_cast<double>(climb.cells()));
    return path.take();
  }

 private:
  static void cover_others(const Problem& problem, const GridGraph& graph, Climb& climb, PathBuilder& path) {
    const auto cell = [&](std::size_t c) {
      const auto columns = static_cast<std::size_t>(graph.columns());
      return std::pair(static_cast<int>(c % columns), static_cast<int>(c / columns));
    };
    std::vector<std::size_t> left;
    for (std::size_t c = 0; c < graph.size(); ++c)
      if (graph.free(cell(c).first, cell(c).second) && !climb.visited(c)) left.push_back(c);
    if (left.empty()) return;
    // Each cell is a part of its own: most parts are single cells, and those of larger ones are dropped as they are met.
    NearestComponent nearest(problem);
    for (std::size_t k = 0; k < left.size(); ++k)
      nearest.add(graph.centre(cell(left[k]).first, cell(left[k]).second), static_cast<int>(k), k);
    while (!climb.cancelled()) {
      const auto found = nearest.from(path.at());
      if (!found) return;
      nearest.remove(static_cast<int>(found->id));
      const std::size_t c = left[found->id];
      if (climb.visited(c)) continue;
      Polyline way = found->path;
      const Point last = way.back();
      way.pop_back();
      path.drive(way, false);
      path.drive(last, true);
      climb.cover_part(c, path);
    }
  }
  Params p_;
};

}  // namespace

PlannerInfo wavefront() {
  return describe<Wavefront, Params>(
      {.name = "wavefront",
       .family = "grid",
       .title = "far cells first, by a distance transform",
       .citation = "Zelinsky et al. 1993",
       .capabilities = {Capability::holes},
       .guarantee = "visits every free cell; with stop = closed only until it is closed in",
       .parameters = {
           {"cell_size", &Params::cell_size, Range{0, 1000}, "side of a cell, metres; 0: tool width / sqrt 2"},
           {"stop", &Params::stop, Choices{"backtrack", "closed"},
            "closed: ends where it is closed in, as published; backtrack: goes on to the nearest unvisited cell"},
           {"transform", &Params::transform, Choices{"distance", "path"}, "path: cells near walls cost more"},
           {"discomfort", &Params::discomfort, Range{0, 100}, "transform = path: steps that closeness to a wall costs"},
           {"goal", &Params::goal, Choices{"start", "farthest"},
            "where the wave spreads from and the path tends to end"},
           {"components", &Params::components, Choices{"all", "start"},
            "start: only the free cells connected to the first one; all: then the other parts"},
           {"align", &Params::align, Choices{"axes", "edges"},
            "edges: turn the grid to the direction most walls run in"},
           {"shift_x", &Params::shift_x, Range{-1, 1}, "shift of the grid, in cells"},
           {"shift_y", &Params::shift_y, Range{-1, 1}, "shift of the grid, in cells"}}});
}

}  // namespace oxturn
