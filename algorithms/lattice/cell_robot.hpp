/// A robot on a lattice: it stands in a cell, feels the cells around it, and steps to a neighbour. It has no other
/// access to the map, so a planner that drives one is an online planner.
///
///   const GridGraph graph = grid_at_start(problem, side);
///   CellRobot robot = robot_at_start(problem, graph);
///   while (robot.step(kEast)) {}
///   Path path = robot.take();
///
/// Cells are counted from the first one, Cell{0, 0}, where the robot begins; the extent of the lattice is not known. On
/// the true map cells are felt by a GridGraph (the model of the literature), otherwise by a CellWorld.
/// Every question and every step O(1), a few nanoseconds on the true map; a point of the path for each turn.
#pragma once

#include <cstdlib>

#include "algorithms/lattice/grid_graph.hpp"
#include "geometry/path.hpp"

namespace oxturn {

/// A lattice that is not read from the true map (but seen by lidar: algorithms/grid/cell_planner.cpp).
/// Answers may change from wall to free while the robot learns.
class CellWorld {
 public:
  virtual ~CellWorld() = default;
  /// The segment between two centres is known to be free, and so are all squares between cells that it meets.
  virtual bool straight(const Cell& from, const Cell& to) = 0;
  /// Drives there. False if the robot was stopped; it is back in the centre of `from` then.
  virtual bool go_straight(const Cell& from, const Cell& to, bool tool) = 0;
  virtual Point centre(const Cell& c) const = 0;
};

class CellRobot final {
 public:
  /// On the true map, in the given cell of the lattice. `path` must end at its centre. `graph` must outlive the robot.
  CellRobot(const GridGraph& graph, const Cell& first, PathBuilder path, int reach = 1)
      : graph_(&graph), first_(first), reach_(reach), side_(graph.side()), path_(std::move(path)) {}
  /// In another world, which records the path itself: take() must not be called.
  CellRobot(CellWorld& world, double side, int reach = 1)
      : world_(&world), reach_(reach), side_(side), path_(world.centre({0, 0})) {}

  double side() const { return side_; }
  const Cell& at() const { return at_; }
  /// How far it feels, in cells; a diagonal step counts as one.
  int reach() const { return reach_; }
  std::size_t steps() const { return steps_; }
  Point centre(const Cell& c) const { return graph_ ? graph_->centre(in_graph(c)) : world_->centre(c); }

  /// Throws std::logic_error for a cell farther away than reach(), as does passable().
  bool free(const Cell& c) const {
    check(c);
    return graph_ ? graph_->free(in_graph(c)) : world_->straight(c, c);
  }
  /// The segment from the centre of c to its neighbour's is free.
  bool passable(const Cell& c, Direction d) const {
    check(c);
    check(neighbour(c, d));
    return graph_ ? graph_->passable(in_graph(c), d) : world_->straight(c, neighbour(c, d));
  }
  bool passable(Direction d) const {
    return graph_ ? graph_->passable(in_graph(at_), d) : world_->straight(at_, neighbour(at_, d));
  }
  /// The robot knows by now that this step is free, at whatever distance. False on the true map, where it knows no more
  /// than it feels.
  bool known_open(const Cell& c, Direction d) const {
    return world_ != nullptr && world_->straight(c, neighbour(c, d));
  }

  /// Drives to the neighbour's centre. False if that is not possible; the robot stays where it is then.
  bool step(Direction d, bool tool = true) {
    if (!graph_) {
      if (!world_->go_straight(at_, neighbour(at_, d), tool)) return false;
    } else {
      if (!passable(d)) return false;
      if (d != heading_ || tool != tool_) turn(d, tool);
    }
    at_ = neighbour(at_, d);
    ++steps_;
    return true;
  }

  /// The segment between two centres is free, and so are all squares between centres that it meets. At any distance:
  /// meant for cells where the robot has been. On the true map only after graph.add_diagonals().
  bool straight(const Cell& from, const Cell& to) const {
    return graph_ ? graph_->straight(in_graph(from), in_graph(to)) : world_->straight(from, to);
  }
  /// Drives straight to a cell, with the tool off; false if that is not possible.
  bool go_straight(const Cell& to);
  /// Leaves the lattice along `points`, which end in the centre of `end`. True map only; the caller knows it is free.
  void drive(const Polyline& points, const Cell& end, bool tool = true);

  /// The lattice and where the robot's cell {0, 0} lies in it, for what is driven off the lattice. True map only.
  struct Lattice {
    const GridGraph& graph;
    Cell first;
  };
  Lattice lattice() const;

  /// The path; a straight run of steps is one segment. Call it once, at the end.
  Path take();

 private:
  Cell in_graph(const Cell& c) const { return {c.i + first_.i, c.j + first_.j}; }
  void check(const Cell& c) const {
    if (std::abs(c.i - at_.i) > reach_ || std::abs(c.j - at_.j) > reach_) [[unlikely]]
      throw_out_of_reach(c);
  }
  [[noreturn]] void throw_out_of_reach(const Cell& c) const;
  void turn(Direction d, bool tool) {
    end_run();
    heading_ = d;
    tool_ = tool;
  }
  // The path begins at the first centre up to rounding, which must not become a segment.
  void end_run() {
    if (steps_ > 0) path_.drive(centre(at_), tool_);
  }

  const GridGraph* graph_ = nullptr;  // either this
  CellWorld* world_ = nullptr;        // or that
  Cell first_;                        // in the graph
  int reach_;
  double side_;
  Cell at_;
  std::size_t steps_ = 0;
  Direction heading_ = kEast;  // of the run of steps that is not yet in the path
  bool tool_ = true;
  PathBuilder path_;
};

/// A lattice over the problem's map that has a node at the start.
GridGraph grid_at_start(const Problem& problem, double side, double angle = 0);
/// A robot in the start's cell of such a lattice. Throws Infeasible if it cannot step anywhere.
CellRobot robot_at_start(const Problem& problem, const GridGraph& graph, int reach = 1);

/// Where a lattice is entered from the start.
struct Entry {
  Cell cell;
  Polyline path;  // from the start to that cell's centre
};
/// The cell under the start if its centre can be reached straight, else the nearest cell by driven path (which builds
/// the problem's shortest paths). nullopt if no cell is free.
std::optional<Entry> entry_from_start(const Problem& problem, const GridGraph& graph);

}  // namespace oxturn
