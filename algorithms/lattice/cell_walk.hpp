// A robot's walk over a lattice, and what it remembers of it: the cells it has been in, the ways it has felt to be open.
//
// A wall that was felt may open later (by lidar what is unknown counts as wall): each time the robot comes through a
// cell it feels anew, and when it finds nothing left to do it asks what it has learnt since. A step that was refused is
// tried again only if it has learnt better, and seven times at most.
//
// Complexity  a step O(1); a way O(cells it looks at), which are those nearer than the answer: marks are stamped, so
//             nothing is ever reset. 6 bytes a cell of the window.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lattice/cell_map.hpp"
#include "algorithms/lattice/cell_robot.hpp"

namespace oxturn {

class CellWalk {
 public:
  CellWalk(CellRobot& robot, Context& context) : robot_(robot), context_(context) { arrive(); }

  const Cell& at() const { return robot_.at(); }
  bool visited(const Cell& c) const { return (marks_.get(c) & kVisited) != 0; }
  /// From a visited cell, as felt when the robot was last there.
  bool open(const Cell& c, Direction d) const { return (marks_.get(c) >> d & 1) != 0; }
  bool open(Direction d) const { return (here_ >> d & 1) != 0; }
  /// Open, and leads to where the robot has not been.
  bool fresh(const Cell& c, Direction d) const { return (fresh_of(marks_.get(c)) >> d & 1) != 0; }
  bool fresh(Direction d) const { return (fresh_of(here_) >> d & 1) != 0; }
  bool any_fresh(const Cell& c) const { return fresh_of(marks_.get(c)) != 0; }
  bool any_fresh() const { return fresh_of(here_) != 0; }

  /// False if the robot could not; then that way counts as closed from now on.
  bool step(Direction d, bool tool = true) {
    if (!robot_.step(d, tool)) {
      refuse(d);
      return false;
    }
    arrive();
    return true;
  }

  /// The shortest way over visited cells to one that is `goal`: breadth-first, neighbours counter-clockwise from east.
  template <class Goal>
  std::optional<std::vector<Direction>> path_to(Goal goal) {
    new_stamp();
    queue_.assign(1, at());
    reached_[at()] = stamp_ << 2;
    for (std::size_t k = 0; k < queue_.size(); ++k) {
      const Cell c = queue_[k];
      if (goal(c)) return way_back_from(c);
      for (const Direction d : kAllDirections) {
        if (!open(c, d)) continue;
        const Cell to = neighbour(c, d);
        if (!visited(to)) continue;
        std::uint32_t& reached = reached_[to];
        if (reached >> 2 == stamp_) continue;
        reached = stamp_ << 2 | static_cast<std::uint32_t>(d);
        queue_.push_back(to);
      }
    }
    return std::nullopt;
  }

  /// The shortest way over visited cells to that one: A*, which looks at little more than the way where nothing is in it.
  std::optional<std::vector<Direction>> path_to_cell(const Cell& goal) {
    new_stamp();
    // Each step brings the goal nearer (the same sum of driven and left), or two farther: two heaps of cells will do.
    const auto left = [&](const Cell& c) { return std::abs(c.i - goal.i) + std::abs(c.j - goal.j); };
    now_.assign(1, {at(), kEast});
    later_.clear();
    while (!now_.empty() || !later_.empty()) {
      if (now_.empty()) now_.swap(later_);
      const auto [c, came] = now_.back();
      now_.pop_back();
      std::uint32_t& reached = reached_[c];
      if (reached >> 2 == stamp_) continue;
      reached = stamp_ << 2 | static_cast<std::uint32_t>(came);
      if (c == goal) return way_back_from(c);
      for (const Direction d : kAllDirections) {
        const Cell to = neighbour(c, d);
        if (!open(c, d) || !visited(to) || reached_.get(to) >> 2 == stamp_) continue;
        (left(to) < left(c) ? now_ : later_).push_back({to, d});
      }
    }
    return std::nullopt;
  }

  /// Walks a way; false if a step was refused. `smooth`: straight over the lattice where that is free.
  bool walk(const std::vector<Direction>& way, bool tool, bool smooth = false) {
    std::vector<Cell> cells{at()};
    for (const Direction d : way) cells.push_back(neighbour(cells.back(), d));
    for (std::size_t k = 0; k < way.size();) {
      std::size_t to = k + 1;
      while (smooth && to < way.size() && robot_.straight(cells[k], cells[to + 1])) ++to;
      if (to == k + 1 || !leap(cells[to], tool)) {
        if (!step(way[k], tool)) return false;
        to = k + 1;
      }
      k = to;
    }
    return true;
  }

  /// Walks there, by another way where one is refused; false if there is no way or somebody cancelled.
  template <class Goal>
  bool go_to(Goal goal, bool tool = false) {
    while (!cancelled()) {
      const auto way = path_to(goal);
      if (!way) return false;
      if (walk(*way, tool)) return true;
    }
    return false;
  }
  bool go_to_cell(const Cell& cell, bool tool = false) {
    while (!cancelled()) {
      const auto way = path_to_cell(cell);
      if (!way) return false;
      if (walk(*way, tool)) return true;
    }
    return false;
  }
  /// To the nearest visited cell beside an unvisited one: when a planner is closed in.
  bool escape() {
    const auto fresh = [this](const Cell& c) { return any_fresh(c); };
    return go_to(fresh) || (look_back() && go_to(fresh));
  }

  /// Leaves the lattice and comes back to it (CellRobot::drive).
  void drive(const Polyline& points, const Cell& end) {
    robot_.drive(points, end);
    arrive();
  }

  /// The direction that has a wall behind it, where explorers begin: first straight south to a wall if there is none.
  Direction back_to_wall() {
    const auto away = [&]() -> std::optional<Direction> {
      for (const Direction d : kAllDirections)
        if (!open(opposite(d))) return d;
      return std::nullopt;
    };
    std::optional<Direction> found = away();
    while (!found && step(kSouth)) found = away();
    return found.value_or(kNorth);
  }

  /// The robot stands in a cell that it was not stepped to: it has been driven off the lattice.
  void arrive() {
    Mark mark = marks_[at()];
    if (!(mark & kVisited)) {
      ++cells_;
      mark |= kVisited;
      for (const Direction d : kAllDirections) {
        const Cell beside = neighbour(at(), d);
        if (!visited(beside)) continue;
        mark |= static_cast<Mark>(kBeenBeside << d);
        marks_[beside] |= static_cast<Mark>(kBeenBeside << opposite(d));
      }
    }
    mark &= static_cast<Mark>(~0xf);
    for (const Direction d : kAllDirections)
      if (!(mark >> 4 >> d & 1) && robot_.passable(d)) mark |= static_cast<Mark>(1 << d);
    here_ = marks_[at()] = mark;
  }

  std::size_t cells() const { return cells_; }
  /// Reports how many cells were visited, in how many moves.
  void report() {
    context_.record("cells", static_cast<double>(cells_));
    context_.record("moves", static_cast<double>(robot_.steps()));
  }
  CellRobot& robot() { return robot_; }
  /// Looks at the clock now and then.
  bool cancelled() {
    if (!cancelled_ && ++asked_ % 256 == 0) cancelled_ = context_.cancelled();
    return cancelled_;
  }

 private:
  // A bit for each direction: 0 to 3 open, 4 to 7 refused, 8 to 11 the robot has been in the cell there. From bit 13 on:
  // how often a step was refused here.
  using Mark = std::uint16_t;
  static constexpr Mark kBeenBeside = 1 << 8, kVisited = 1 << 12, kMostRefusals = 7;
  static unsigned fresh_of(Mark mark) { return mark & ~(mark >> 8) & 0xfu; }
  static constexpr std::uint32_t kLastStamp = (1u << 30) - 1;

  // After a search in vain, which has been everywhere: is any way open of which the robot did not know when it was there?
  bool look_back() {
    bool found = false;
    for (const Cell& c : queue_) {
      Mark& mark = marks_[c];
      for (const Direction d : kAllDirections) {
        const bool refused = (mark >> 4 >> d & 1) != 0;
        if (((mark | mark >> 8) >> d & 1) || (refused && mark >> 13 == kMostRefusals) || !robot_.learnt(c, d)) continue;
        mark = static_cast<Mark>((mark & ~(1 << (4 + d))) | 1 << d);
        found = true;
      }
    }
    here_ = marks_[at()];
    return found;
  }
  void new_stamp() {
    if (++stamp_ <= kLastStamp) return;
    reached_ = {};
    stamp_ = 1;
  }
  bool leap(const Cell& to, bool tool) {
    if (!robot_.go_straight(to, tool)) return false;
    arrive();
    return true;
  }
  void refuse(Direction d) { here_ = marks_[at()] = static_cast<Mark>((here_ | 1 << (4 + d)) & ~(1 << d)); }
  std::vector<Direction> way_back_from(Cell c) const {
    std::vector<Direction> way;
    while (c != at()) {
      way.push_back(static_cast<Direction>(reached_.get(c) & 3));
      c = neighbour(c, opposite(way.back()));
    }
    std::reverse(way.begin(), way.end());
    return way;
  }

  CellRobot& robot_;
  Context& context_;
  CellMap<Mark> marks_;
  Mark here_ = 0;                   // of the robot's cell
  CellMap<std::uint32_t> reached_;  // by the search of that stamp, in that direction
  std::vector<Cell> queue_;
  std::vector<std::pair<Cell, Direction>> now_, later_;
  std::uint32_t stamp_ = 0;
  std::size_t cells_ = 0, asked_ = 0;
  bool cancelled_ = false;
};

}  // namespace oxturn
