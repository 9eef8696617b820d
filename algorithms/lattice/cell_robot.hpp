// A robot on a lattice: it stands in a cell, feels the cells about it, and steps to a neighbour. It knows nothing else,
// which is what makes a planner that drives one an online planner.
//
// Cells are counted from the first one, Cell{0, 0}, where the robot stands at the beginning: nothing tells how far the
// lattice goes. On the true map a cell is felt by its GridGraph (the papers' model); a CellWorld feels it otherwise.
//
// Complexity  every question and every step O(1), a few nanoseconds on the true map; a point of the path for each turn
#pragma once

#include <cstdlib>

#include "algorithms/lattice/grid_graph.hpp"
#include "geometry/path.hpp"

namespace oxturn {

struct Cell {
  int i = 0, j = 0;
  bool operator==(const Cell&) const = default;
};
inline Cell neighbour(const Cell& c, Direction d) { return {c.i + kColumnStep[d], c.j + kRowStep[d]}; }

/// A lattice that is not felt on the true map (by lidar: algorithms/online/lidar_cells.hpp). Answers may change from
/// wall to free while the robot learns.
class CellWorld {
 public:
  virtual ~CellWorld() = default;
  virtual bool free(const Cell& c) = 0;
  virtual bool passable(const Cell& c, Direction d) = 0;
  /// Drives from the centre of c to its neighbour's; false if that was not to be (it stands in c's centre again).
  virtual bool step(const Cell& c, Direction d, bool tool) = 0;
  /// The same between cells that are not neighbours, over squares between cells of which all is known to be free.
  virtual bool straight(const Cell& from, const Cell& to) = 0;
  virtual bool go_straight(const Cell& from, const Cell& to, bool tool) = 0;
  virtual Point centre(const Cell& c) const = 0;
};

class CellRobot final {
 public:
  /// On the true map, in that cell of the lattice. `path` must end at its centre. `graph` must outlive the robot.
  CellRobot(const GridGraph& graph, int first_column, int first_row, PathBuilder path, int reach = 1)
      : graph_(&graph), i0_(first_column), j0_(first_row), reach_(reach), side_(graph.side()), path_(std::move(path)) {}
  /// In another world; it keeps the path itself, so take() is not for it.
  CellRobot(CellWorld& world, double side, int reach = 1)
      : world_(&world), reach_(reach), side_(side), path_(world.centre({0, 0})) {}

  double side() const { return side_; }
  const Cell& at() const { return at_; }
  /// How far it feels, in cells, diagonals counted as one.
  int reach() const { return reach_; }
  std::size_t steps() const { return steps_; }
  Point centre(const Cell& c) const { return graph_ ? graph_->centre(c.i + i0_, c.j + j0_) : world_->centre(c); }

  /// Both throw std::logic_error about a cell farther away than reach().
  bool free(const Cell& c) const {
    check(c);
    return graph_ ? graph_->free(c.i + i0_, c.j + j0_) : world_->free(c);
  }
  /// The straight way from the centre of c to its neighbour's is free.
  bool passable(const Cell& c, Direction d) const {
    check(c);
    check(neighbour(c, d));
    return graph_ ? graph_->passable(c.i + i0_, c.j + j0_, d) : world_->passable(c, d);
  }
  bool passable(Direction d) const {
    return graph_ ? graph_->passable(at_.i + i0_, at_.j + j0_, d) : world_->passable(at_, d);
  }

  /// Does it know by now that this way is free, however far away? Only a robot that sees farther than it feels does.
  bool learnt(const Cell& c, Direction d) const { return world_ != nullptr && world_->passable(c, d); }

  /// Drives to the neighbour's centre; false, and it stands where it stood, if that could not be.
  bool step(Direction d, bool tool = true) {
    if (!graph_) {
      if (!world_->step(at_, d, tool)) return false;
    } else {
      if (!passable(d)) return false;
      if (d != heading_ || tool != tool_) turn(d, tool);
    }
    at_ = neighbour(at_, d);
    ++steps_;
    return true;
  }

  /// The straight way between two centres, and all of every square between centres that it meets, is free. Not a
  /// question of feeling: for ways among cells where the robot has been. On the true map after graph.look_between().
  bool straight(const Cell& from, const Cell& to) const {
    return graph_ ? graph_->straight(from.i + i0_, from.j + j0_, to.i + i0_, to.j + j0_) : world_->straight(from, to);
  }
  /// Drives there; false if that could not be.
  bool go_straight(const Cell& to, bool tool);
  /// Leaves the lattice along `points`, which end in the centre of `end` (true map only). The caller knows it is free.
  void drive(const Polyline& points, const Cell& end, bool tool = true);

  /// The lattice it drives on, and where its cell {0, 0} is in that: for what is driven off the lattice (true map only).
  struct Lattice {
    const GridGraph& graph;
    int column, row;
  };
  Lattice lattice() const;

  /// The path, straight runs of steps being one segment. The robot is done with then.
  Path take();

 private:
  void check(const Cell& c) const {
    if (std::abs(c.i - at_.i) > reach_ || std::abs(c.j - at_.j) > reach_) [[unlikely]]
      feels_too_far(c);
  }
  [[noreturn]] void feels_too_far(const Cell& c) const;
  void turn(Direction d, bool tool) {
    reach_turn();
    heading_ = d;
    tool_ = tool;
  }
  // The first centre is where the path begins but for rounding, which must not become a segment.
  void reach_turn() {
    if (steps_ > 0) path_.drive(centre(at_), tool_);
  }

  const GridGraph* graph_ = nullptr;  // or else
  CellWorld* world_ = nullptr;
  int i0_ = 0, j0_ = 0, reach_;
  double side_;
  Cell at_;
  std::size_t steps_ = 0;
  Direction heading_ = kEast;  // of the run of steps that is not yet in the path
  bool tool_ = true;
  PathBuilder path_;
};

/// On the true map, on a lattice that hangs on the start.
GridGraph grid_about_start(const Problem& problem, double side, double angle = 0);
/// The robot in the start's cell of such a lattice. Throws Infeasible if it cannot step anywhere.
CellRobot robot_at_start(const Problem& problem, const GridGraph& graph, int reach = 1);

/// Where a lattice is entered from the start.
struct Entry {
  int column, row;
  Polyline way;  // from the start to that cell's centre
};
/// The cell under the start if the straight way to its centre is free, else the nearest by driven way (only then are
/// shortest paths built). nullopt if no cell is free.
std::optional<Entry> entry_from_start(const Problem& problem, const GridGraph& graph);

}  // namespace oxturn
