// Climbs a distance transform: far cells first, down to the goal last.
//
// Source      after Zelinsky, Jarvis, Byrne & Yuta, "Planning paths of complete coverage of an unstructured environment
//             by a mobile robot", ICAR 1993
// Model       grid with eight neighbours, offline, disc footprint
// Guarantee   stop = backtrack: visits every free cell that free steps connect to the first one; with components = all
//             every free cell. stop = closed (as published): only until the robot is closed in
// Complexity  n cells: memory O(n); time O(n) plus, each time that the robot is closed in, the cells nearer than the
//             next unvisited one; transform = path costs O(n log n) more
// Decisions   1. The wave spreads from the goal to all eight neighbours, each step costing one. A problem has no goal:
//                it is the start's cell, or with `goal = farthest` the cell farthest from it.
//             2. A step is possible where its segment lies in configuration space, exactly; diagonal steps as well.
//             3. Of the unvisited neighbours with the greatest height: the one with the smallest turn, then the left
//                one.
//             4. The source stops when closed in. `stop = backtrack` (our default) goes on to the nearest unvisited
//                cell, breadth-first over visited ones, with the tool off.
//             5. transform = path (Zelinsky's path transform): a step costs 1 plus `discomfort` times the cell's
//                closeness to walls, which is 3, 2, 1 for the first three cells from a wall, else 0. So the path
//                follows the walls.
//             6. components = all (ours) covers the components that no lattice step leads to as well: where the path
//                passes the cell that is nearest to another component, the robot goes there by a shortest path, covers
//                it and comes back (component_links.hpp). Each has a wave of its own, from where it is entered.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lattice/cell_robot.hpp"
#include "algorithms/lattice/grid_options.hpp"
#include "algorithms/lattice/promised_cells.hpp"
#include "algorithms/transit/component_links.hpp"
#include "base/graph_search.hpp"

namespace oxturn {
namespace {

enum class Stop { backtrack, closed };
enum class Transform { distance, path };
enum class Goal { start, farthest };

struct Params : GridOptions {
  Stop stop = Stop::backtrack;
  Transform transform = Transform::distance;
  double discomfort = 2;
  Goal goal = Goal::start;
  Components components = Components::all;
};

// The eight directions, counter-clockwise from east.
constexpr std::array<int, 8> kStepColumn{1, 1, 0, -1, -1, -1, 0, 1}, kStepRow{0, 1, 1, 1, 0, -1, -1, -1};
constexpr std::uint8_t kAllOpen = 0xff;

class Climb {
 public:
  Climb(const Params& p, const GridGraph& graph, Context& context)
      : p_(p),
        graph_(graph),
        context_(context),
        open_(graph.size(), 0),
        height_(graph.size(), kNever),
        states_(graph.size()) {
    for (std::size_t d = 0; d < 8; ++d) step_[d] = kStepColumn[d] + std::ptrdiff_t{kStepRow[d]} * graph.columns();
    for (int j = 0; j < graph.rows(); ++j)
      for (int i = 0; i < graph.columns(); ++i)
        for (std::size_t d = 0; d < 8; ++d)
          if (d % 2 == 0 ? graph.passable(i, j, static_cast<Direction>(d / 2))
                         : graph.diagonal(i, j, kStepColumn[d], kStepRow[d]))
            open_[graph.at(i, j)] |= static_cast<std::uint8_t>(1 << d);
  }

  bool visited(std::size_t c) const { return states_[c].visited; }
  /// Looks at the clock at every 256th call.
  bool cancelled() {
    if (!cancelled_ && ++asked_ % 256 == 0) cancelled_ = context_.cancelled();
    return cancelled_;
  }
  std::size_t visited_count() const { return visited_count_; }

  /// The components of the cells by free steps.
  ConnectedComponents components() const {
    return connected_components(
        graph_.size(), [this](std::size_t c) { return graph_.free(graph_.cell(c)); },
        [this](std::size_t c, const auto& reach) {
          for_each_neighbour(c, [&](std::size_t, std::size_t to) { reach(to); });
        });
  }
  bool on_boundary(std::size_t c) const { return open_[c] != kAllOpen; }
  /// Where the path visits cell `from`, it goes along `link` into another component, covers it and comes back.
  void attach(std::size_t from, std::size_t to, Polyline link) {
    detour_from_.resize(graph_.size(), false);
    detour_from_[from] = true;
    detours_[from].push_back({to, std::move(link)});
  }

  /// Covers what is connected to cell c, where the path ends. Detours lead to further components from which detours
  /// lead on, so their number may be that of the components: by a stack of its own, not by recursion.
  void cover_from(std::size_t c, PathBuilder& path) {
    std::vector<Cover> covers;
    covers.push_back(begin_at(c, path));
    while (!covers.empty()) {
      Cover& cover = covers.back();
      if (!cover.detours.empty()) {
        Detour detour = std::move(cover.detours.back());
        cover.detours.pop_back();
        Polyline back(detour.link.rbegin(), detour.link.rend());
        detour.link.pop_back();
        path.drive(detour.link, false);
        path.drive(graph_.centre(detour.to), true);
        covers.push_back(begin_at(detour.to, path));
        covers.back().back = std::move(back);
      } else if (!advance(cover, path)) {
        if (cover.back) {
          for (const std::size_t k : path_to(cover.at, cover.first)) path.drive(graph_.centre(k), false);
          path.drive(*cover.back, false);
        }
        covers.pop_back();
      }
    }
  }

 private:
  static constexpr std::uint32_t kNever = 0xffffffff, kLastSearch = (1u << 28) - 1;
  struct State {
    std::uint32_t visited : 1 = 0;
    std::uint32_t search : 28 = 0;  // the last search out of a dead end that reached the cell
    std::uint32_t entered : 3 = 0;  // in which direction it did
  };

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

  /// The wave; `queue_` gets its cells in order.
  void spread(std::size_t from) {
    queue_.assign(1, from);
    height_[from] = 0;
    breadth_first(queue_, [this](std::size_t c, const auto& reach) {
      for_each_neighbour(c, [&](std::size_t, std::size_t to) {
        if (height_[to] != kNever) return;
        height_[to] = height_[c] + 1;
        reach(to);
      });
    });
  }

  /// Of each cell in `queue_`: 3, 2, 1 for the first cells from a wall, else 0.
  std::vector<std::uint8_t> closeness() const {
    constexpr std::uint8_t kReached = 0xff;
    std::vector<std::uint8_t> close(graph_.size(), 0);
    std::vector<std::size_t> layer, next;
    for (const std::size_t c : queue_)
      if (open_[c] != kAllOpen) layer.push_back(c);
    for (std::uint8_t value = 3; value > 0; --value) {
      next.clear();
      for (const std::size_t c : layer) close[c] = value;
      for (const std::size_t c : layer)
        for_each_neighbour(c, [&](std::size_t, std::size_t to) {
          if (close[to] != 0) return;
          close[to] = kReached;
          next.push_back(to);
        });
      layer.swap(next);
    }
    for (const std::size_t c : layer) close[c] = 0;
    return close;
  }

  /// Decision 5. Costs are hundredths, so that equal heights are equal.
  void add_discomfort(std::size_t goal) {
    const std::vector<std::uint8_t> close = closeness();
    const auto unit = static_cast<std::uint32_t>(std::lround(100 * p_.discomfort));
    SearchTree<std::uint32_t> costs;
    dijkstra(costs, graph_.size(), goal, [&](std::size_t c, const auto& reach) {
      for_each_neighbour(c, [&](std::size_t, std::size_t to) { reach(to, 100 + unit * close[to]); });
    });
    for (const std::size_t c : queue_) height_[c] = costs.cost(c);
  }

  struct Detour {
    std::size_t to;
    Polyline link;
  };
  /// A component that is being covered.
  struct Cover {
    std::size_t first, at;         // cells: where the robot entered, and is
    std::size_t heading;           // a direction
    std::vector<Detour> detours;   // from `at`, not yet driven, the next one last
    std::optional<Polyline> back;  // to where the detour to this component began; none: the path ends here
  };

  /// Makes the wave and visits the first cell.
  Cover begin_at(std::size_t c, PathBuilder& path) {
    std::size_t goal = c;
    spread(goal);
    if (p_.goal == Goal::farthest) {
      goal = queue_.back();
      for (const std::size_t k : queue_) height_[k] = kNever;
      spread(goal);
    }
    if (p_.transform == Transform::path) add_discomfort(goal);
    Cover cover{c, c, 0, {}, {}};
    visit(cover, path);
    return cover;
  }

  /// One step, or out of a dead end. False: all is covered.
  bool advance(Cover& cover, PathBuilder& path) {
    const auto next = cancelled() ? std::nullopt : highest(cover.at, cover.heading);
    if (next) {
      if (*next != cover.heading) path.drive(graph_.centre(cover.at), true);  // straight runs are one segment
      cover.heading = *next;
      cover.at = neighbour(cover.at, cover.heading);
      visit(cover, path);
      return true;
    }
    path.drive(graph_.centre(cover.at), true);
    if (cancelled_ || p_.stop == Stop::closed) return false;
    const auto out = path_out(cover.at);
    if (!out) return false;
    for (const std::size_t k : *out) path.drive(graph_.centre(k), false);
    if (!out->empty()) cover.at = out->back();
    return true;
  }

  /// The cell where the robot is, and the detours from it (Decision 6).
  void visit(Cover& cover, PathBuilder& path) {
    State& state = states_[cover.at];
    visited_count_ += state.visited == 0;
    state.visited = 1;
    if (detour_from_.empty() || !detour_from_[cover.at]) return;
    detour_from_[cover.at] = false;
    path.drive(graph_.centre(cover.at), true);
    cover.detours = std::move(detours_[cover.at]);
    std::reverse(cover.detours.begin(), cover.detours.end());
  }

  /// Decision 3.
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

  /// Over visited cells to the nearest one beside an unvisited cell; without the first cell.
  std::optional<std::vector<std::size_t>> path_out(std::size_t from) {
    return search(from, [this](std::size_t c) {
      for (unsigned open = open_[c]; open != 0; open &= open - 1)
        if (!visited(neighbour(c, static_cast<std::size_t>(std::countr_zero(open))))) return true;
      return false;
    });
  }
  /// Between two cells of a component that has been covered; without the first one.
  std::vector<std::size_t> path_to(std::size_t from, std::size_t to) {
    return search(from, [to](std::size_t c) { return c == to; }).value_or(std::vector<std::size_t>{});
  }
  template <class Goal>
  std::optional<std::vector<std::size_t>> search(std::size_t from, Goal goal) {
    begin_search();
    queue_.assign(1, from);
    states_[from].search = search_;
    const auto expand = [this](std::size_t c, const auto& reach) {
      for_each_neighbour(c, [&](std::size_t d, std::size_t to) {  // all of them are visited
        State& state = states_[to];
        if (state.search == search_) return;
        state.search = search_;
        state.entered = static_cast<unsigned>(d);
        reach(to);
      });
    };
    const auto found = breadth_first(queue_, expand, goal);
    if (!found) return std::nullopt;
    std::vector<std::size_t> path;
    for (std::size_t at = queue_[*found]; at != from; at = neighbour(at, (states_[at].entered + 4u) % 8))
      path.push_back(at);
    std::reverse(path.begin(), path.end());
    return path;
  }
  void begin_search() {
    if (++search_ <= kLastSearch) return;
    for (State& state : states_) state.search = 0;
    search_ = 1;
  }

  const Params& p_;
  const GridGraph& graph_;
  Context& context_;
  std::vector<std::uint8_t> open_;      // of each cell a bit for each direction in which it can be left
  std::array<std::ptrdiff_t, 8> step_;  // from a cell's number to those of its neighbours
  std::vector<std::uint32_t> height_;
  std::vector<State> states_;
  std::vector<std::size_t> queue_;
  std::vector<bool> detour_from_;                       // cells
  std::map<std::size_t, std::vector<Detour>> detours_;  // by the cell where they begin
  std::uint32_t search_ = 0;
  std::size_t visited_count_ = 0, asked_ = 0;
  bool cancelled_ = false;
};

/// Decision 6.
void attach_other_components(const Problem& problem, const GridGraph& graph, std::size_t start, Climb& climb) {
  const ConnectedComponents components = climb.components();
  if (components.count < 2) return;
  ComponentLinks links(problem);
  for (std::size_t c = 0; c < graph.size(); ++c)
    if (components.of[c] >= 0 && climb.on_boundary(c)) links.add(graph.centre(graph.cell(c)), components.of[c], c);
  for (ComponentLinks::Link& link : links.tree(components.of[start]))
    climb.attach(link.from, link.to, std::move(link.path));
}

Path plan(const Params& p, const Problem& problem, Context& context) {
  GridGraph graph = p.lattice(problem, 1);
  graph.add_diagonals(problem.configuration_space());
  const std::optional<Entry> entry = entry_from_start(problem, graph);
  if (!entry) throw Infeasible("no cell's centre is free; a smaller cell_size, or a shift of the grid, may help");
  if (p.stop == Stop::backtrack)
    promise_free_cells(context, graph, p.components, entry->cell, problem.robot().tool_width);
  PathBuilder path(problem.start());
  // The entry may be its component's only cell, so the tool is on already when the robot arrives.
  path.drive(entry->path, true);
  Climb climb(p, graph, context);
  if (p.components == Components::all && p.stop == Stop::backtrack)
    attach_other_components(problem, graph, graph.at(entry->cell), climb);
  climb.cover_from(graph.at(entry->cell), path);
  context.record("cells", static_cast<double>(climb.visited_count()));
  return path.take();
}

}  // namespace

PlannerInfo wavefront() {
  return describe<Params, plan>(
      {.name = "wavefront",
       .family = "grid",
       .title = "far cells first, by a distance transform",
       .citation = "Zelinsky et al. 1993",
       .capabilities = {Capability::holes},
       .guarantee = "visits every free cell; with stop = closed only until it is closed in",
       .promise = Promise::cells,
       .symmetries = {Symmetry::shift, Symmetry::scale},
       .parameters = with_grid_options<Params>(
           {{"stop", &Params::stop, Choices{"backtrack", "closed"},
             "closed: ends where it is closed in (as published); backtrack: goes on to the nearest unvisited cell"},
            {"transform", &Params::transform, Choices{"distance", "path"}, "path: cells near walls cost more"},
            {"discomfort", &Params::discomfort, Range{0, 100},
             "transform = path: steps that closeness to a wall costs"},
            {"goal", &Params::goal, Choices{"start", "farthest"},
             "where the wave spreads from and the path tends to end"},
            components_line<Params>()}),
       .published = {{"components", "start"}, {"stop", "closed"}}});
}

}  // namespace oxturn
