/// A robot's walk over a lattice and what it remembers: the cells it has visited, and the steps it felt to be open.
///
///   CellWalk walk(robot, context);
///   do {
///     while (walk.step_to_any_fresh_cell()) {}        // the planner's own rule, from fresh() and step()
///   } while (walk.escape());                          // to the nearest cell beside an unvisited one
///
/// A wall that was felt may turn out to be open later (by lidar, what is unknown counts as wall). So the robot feels
/// anew each time it comes through a cell, and when it finds nothing left to do it checks what it has learnt since. A
/// step that was refused is tried again only if it has become known to be free since.
/// A step O(1); a path O(cells nearer than its end), because marks of earlier searches need no reset. 6 bytes a cell of
/// the window.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lattice/cell_map.hpp"
#include "algorithms/lattice/cell_robot.hpp"
#include "base/graph_search.hpp"

namespace oxturn {

class CellWalk {
 public:
  using Steps = std::vector<Direction>;
  CellWalk(CellRobot& robot, Context& context) : robot_(robot), context_(context) { arrive(); }

  const Cell& at() const { return robot_.at(); }
  bool visited(const Cell& c) const { return marks_.get(c).visited; }
  /// A step from a visited cell is free, as felt when the robot was last there.
  bool open(const Cell& c, Direction d) const { return (marks_.get(c).open >> d & 1) != 0; }
  bool open(Direction d) const { return (here_.open >> d & 1) != 0; }
  /// The step is open and leads to an unvisited cell.
  bool fresh(const Cell& c, Direction d) const { return (marks_.get(c).fresh() >> d & 1) != 0; }
  bool fresh(Direction d) const { return (here_.fresh() >> d & 1) != 0; }
  bool any_fresh(const Cell& c) const { return marks_.get(c).fresh() != 0; }
  bool any_fresh() const { return here_.fresh() != 0; }

  /// False if the robot was stopped; the step counts as closed from then on.
  bool step(Direction d, bool tool = true) {
    if (!robot_.step(d, tool)) {
      refuse(d);
      return false;
    }
    arrive();
    return true;
  }

  /// The fewest steps over visited cells to one with goal(cell). Neighbours are tried counter-clockwise from east.
  template <class Goal>
  std::optional<Steps> path_to(Goal goal) {
    begin_search();
    queue_.assign(1, at());
    reach(at(), kEast);
    const auto expand = [this](const Cell& c, auto append) {
      for (const Direction d : kAllDirections) {
        if (!open(c, d)) continue;
        const Cell to = neighbour(c, d);
        if (visited(to) && reach(to, d)) append(to);
      }
    };
    const auto found = breadth_first(queue_, expand, goal);
    if (!found) return std::nullopt;
    return steps_to(queue_[*found]);
  }

  /// The fewest steps over visited cells to one cell: A*, which looks at few other cells where nothing is in the way.
  /// base/graph_search.hpp would need the extent of the lattice and a heap. Here a step either keeps the sum of steps
  /// driven and steps left, or raises it by two, so two stacks do.
  std::optional<Steps> path_to_cell(const Cell& goal) {
    begin_search();
    const auto left = [&](const Cell& c) { return std::abs(c.i - goal.i) + std::abs(c.j - goal.j); };
    now_.assign(1, {at(), kEast});
    later_.clear();
    while (!now_.empty() || !later_.empty()) {
      if (now_.empty()) now_.swap(later_);
      const auto [c, came] = now_.back();
      now_.pop_back();
      if (!reach(c, came)) continue;
      if (c == goal) return steps_to(c);
      for (const Direction d : kAllDirections) {
        const Cell to = neighbour(c, d);
        if (!open(c, d) || !visited(to) || reached_.get(to).search == search_) continue;
        (left(to) < left(c) ? now_ : later_).push_back({to, d});
      }
    }
    return std::nullopt;
  }

  /// With the tool off. False if a step was refused; the robot is where it was stopped then.
  bool follow(const Steps& steps) {
    return std::all_of(steps.begin(), steps.end(), [this](Direction d) { return step(d, false); });
  }
  /// The same, but from each cell straight to the farthest cell of the path for which that is possible.
  bool follow_smoothed(const Steps& steps) {
    std::vector<Cell> cells{at()};
    for (const Direction d : steps) cells.push_back(neighbour(cells.back(), d));
    for (std::size_t k = 0; k < steps.size();) {
      std::size_t to = k + 1;
      while (to < steps.size() && robot_.straight(cells[k], cells[to + 1])) ++to;
      if (to == k + 1 || !go_straight(cells[to])) {
        if (!step(steps[k], false)) return false;
        to = k + 1;
      }
      k = to;
    }
    return true;
  }

  /// Goes to the nearest visited cell with goal(cell), by another path where a step is refused. False if there is none,
  /// or the run is cancelled.
  template <class Goal>
  bool go_to(Goal goal) {
    return go_by([&] { return path_to(goal); });
  }
  bool go_to_cell(const Cell& cell) {
    return go_by([&] { return path_to_cell(cell); });
  }
  /// Goes to the nearest visited cell beside an unvisited one: for a robot that is closed in.
  bool escape() {
    const auto has_fresh = [this](const Cell& c) { return any_fresh(c); };
    return go_to(has_fresh) || (reopen_known_steps() && go_to(has_fresh));
  }

  /// Leaves the lattice and comes back to it (CellRobot::drive).
  void drive(const Polyline& points, const Cell& end) {
    robot_.drive(points, end);
    arrive();
  }

  /// The heading with which exploration begins: away from a wall. Without a wall beside it the robot first drives
  /// straight south to one.
  Direction heading_from_wall() {
    const auto from_wall = [&]() -> std::optional<Direction> {
      for (const Direction d : kAllDirections)
        if (!open(opposite(d))) return d;
      return std::nullopt;
    };
    std::optional<Direction> found = from_wall();
    while (!found && step(kSouth)) found = from_wall();
    return found.value_or(kNorth);
  }

  /// Records how many cells were visited, in how many moves.
  void record_figures() {
    context_.record("cells", static_cast<double>(cells_));
    context_.record("moves", static_cast<double>(robot_.steps()));
  }
  CellRobot& robot() { return robot_; }
  /// Looks at the clock at every 256th call.
  bool cancelled() {
    if (!cancelled_ && ++asked_ % 256 == 0) cancelled_ = context_.cancelled();
    return cancelled_;
  }

 private:
  // Four bits are a set of directions.
  struct Mark {
    std::uint16_t open : 4 = 0;            // the step was felt to be free
    std::uint16_t refused : 4 = 0;         // the step was tried in vain
    std::uint16_t beside_visited : 4 = 0;  // the neighbour was visited
    std::uint16_t visited : 1 = 0;
    unsigned fresh() const { return open & ~unsigned{beside_visited}; }
  };
  struct Reached {
    std::uint32_t search : 30 = 0;  // the last search that reached the cell
    std::uint32_t by : 2 = 0;       // the direction of the step that led there
  };
  static constexpr std::uint32_t kLastSearch = (1u << 30) - 1;

  template <class PathTo>
  bool go_by(PathTo path) {
    while (!cancelled()) {
      const std::optional<Steps> steps = path();
      if (!steps) return false;
      if (follow(*steps)) return true;
    }
    return false;
  }
  void arrive() {
    Mark mark = marks_[at()];
    if (!mark.visited) {
      ++cells_;
      mark.visited = 1;
      for (const Direction d : kAllDirections) {
        const Cell beside = neighbour(at(), d);
        if (!visited(beside)) continue;
        mark.beside_visited |= 1 << d;
        marks_[beside].beside_visited |= 1 << opposite(d);
      }
    }
    mark.open = 0;
    for (const Direction d : kAllDirections)
      if (!(mark.refused >> d & 1) && robot_.passable(d)) mark.open |= 1 << d;
    here_ = marks_[at()] = mark;
  }
  void refuse(Direction d) {
    here_.refused |= 1 << d;
    here_.open &= ~(1 << d);
    marks_[at()] = here_;
  }
  bool go_straight(const Cell& to) {
    if (!robot_.go_straight(to)) return false;
    arrive();
    return true;
  }

  // After a search without success, which has reached all visited cells: opens the steps that were closed when the
  // robot was there and are known to be free now. False if there are none.
  bool reopen_known_steps() {
    bool found = false;
    for (const Cell& c : queue_) {
      Mark& mark = marks_[c];
      for (const Direction d : kAllDirections) {
        if (((mark.open | mark.beside_visited) >> d & 1) || !robot_.known_open(c, d)) continue;
        mark.refused &= ~(1 << d);
        mark.open |= 1 << d;
        found = true;
      }
    }
    here_ = marks_[at()];
    return found;
  }

  void begin_search() {
    if (++search_ <= kLastSearch) return;
    reached_ = {};
    search_ = 1;
  }
  /// False if the current search has reached the cell before.
  bool reach(const Cell& c, Direction by) {
    Reached& reached = reached_[c];
    if (reached.search == search_) return false;
    reached.search = search_;
    reached.by = static_cast<unsigned>(by);
    return true;
  }
  Steps steps_to(Cell c) const {
    Steps steps;
    while (c != at()) {
      steps.push_back(static_cast<Direction>(unsigned{reached_.get(c).by}));
      c = neighbour(c, opposite(steps.back()));
    }
    std::reverse(steps.begin(), steps.end());
    return steps;
  }

  CellRobot& robot_;
  Context& context_;
  CellMap<Mark> marks_;
  Mark here_;  // of the robot's cell
  CellMap<Reached> reached_;
  std::vector<Cell> queue_;
  std::vector<std::pair<Cell, Direction>> now_, later_;
  std::uint32_t search_ = 0;
  std::size_t cells_ = 0, asked_ = 0;
  bool cancelled_ = false;
};

}  // namespace oxturn
