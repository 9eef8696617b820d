/// A spanning tree of coarse cells at the level of their sub-cells, and the path around it: for spanning tree coverage
/// that grows its tree while driving, or that enters partly occupied coarse cells.
///
///   SubCellTree tree([&](const Cell& c, Direction d) { return graph.passable(c.i, c.j, d); }, corner);
///   tree.add_node({0, 0});
///   tree.link({1, 0}, kEast);
///   tree.go_round({0, 0}, [](const Cell&, Direction) { return false; }, [&](Direction d) { return robot.step(d); });
///
/// A node of the tree is a connected component of a coarse cell's free sub-cells: all four, three, two or one of them;
/// two diagonal sub-cells are two nodes. An edge is double-sided where both lattice edges across fit: the robot leaves
/// by one, returns by the other, and does not drive the cell's side between them. Otherwise it is single-sided: out and
/// back by the same lattice edge. The tree is stored as the lattice edges to be driven, called `open`. The robot keeps
/// to the right: at each sub-cell it takes the first open edge of right, ahead, left, back. So it drives around the
/// tree, which stays on its left, and looks across every side of every sub-cell once.
///
///       double-sided              single-sided
///     o - o - o - o              o - o   #            o  sub-cell, # blocked one
///     |           |              |   |
///     o - o - o - o              o - o = o            =  driven twice
///
/// Source      Gabriely & Rimon, ICRA 2001; after "Competitive on-line coverage of grid environments by a mobile
///             robot", Computational Geometry 24, 2003
/// Guarantee   the round is closed and takes n + 2 s + t - p steps for n sub-cells, s single-sided edges, t nodes of
///             three sub-cells and p nodes of one. A node is one edge from its parent, so that is at most n + m for the
///             m sub-cells that share a point with a blocked one: a node of 1, 2, 3 sub-cells has as many of these and
///             costs 1, 2, 3 steps more than n with its single-sided edge. A whole node costs 2 more only where a
///             sub-cell facing it is blocked, which then touches two of its own. Blocked edges between free sub-cells
///             count alike.
/// Complexity  O(1) for a query, a link and a step; 2 bytes a sub-cell of the window
#pragma once

#include <cstdint>

#include "algorithms/lattice/cell_map.hpp"

namespace oxturn {

/// `Passable`: bool(const Cell&, Direction), whether a lattice edge between sub-cells is free.
template <class Passable>
class SubCellTree {
 public:
  /// `corner`: the lower left sub-cell of some coarse cell.
  SubCellTree(Passable passable, const Cell& corner) : passable_(std::move(passable)), corner_(corner) {}

  bool passable(const Cell& c, Direction d) const { return passable_(c, d); }
  /// The sub-cell belongs to a node of the tree.
  bool contains(const Cell& c) const { return marks_.get(c).contained; }
  bool open(const Cell& c, Direction d) const { return (marks_.get(c).open >> d & 1) != 0; }
  /// The lower left sub-cell of c's coarse cell.
  Cell base(const Cell& c) const { return {c.i - ((c.i - corner_.i) & 1), c.j - ((c.j - corner_.j) & 1)}; }
  /// The neighbour in this direction belongs to the same coarse cell.
  bool inner(const Cell& c, Direction d) const {
    return d == kEast || d == kWest ? ((c.i - corner_.i) & 1) == (d == kWest)
                                    : ((c.j - corner_.j) & 1) == (d == kSouth);
  }
  /// Counter-clockwise around the coarse cell, c is the first of the two sub-cells on its side d.
  bool first_on_side(const Cell& c, Direction d) const { return inner(c, left_of(d)); }
  /// All four sub-cells are free, and the lattice edges between them.
  bool whole(const Cell& c) const {
    const Cell b = base(c), east = neighbour(b, kEast), north = neighbour(b, kNorth);
    return passable(b, kEast) && passable(b, kNorth) && passable(east, kNorth) && passable(north, kEast);
  }
  /// An edge out of c's coarse cell over its side d, on which c lies, would be double-sided.
  bool double_sided(const Cell& c, Direction d) const {
    const Direction along = along_side(c, d);
    return passable(c, d) && passable(c, along) && passable(neighbour(c, along), d) && passable(neighbour(c, d), along);
  }

  /// Adds the node that c belongs to, without any edge.
  void add_node(const Cell& c) {
    if (whole(c)) {
      const Cell b = base(c), east = neighbour(b, kEast), north = neighbour(b, kNorth);
      add_corner(b, kEast, kNorth);
      add_corner(east, kWest, kNorth);
      add_corner(north, kEast, kSouth);
      add_corner(neighbour(north, kEast), kWest, kSouth);
      return;
    }
    marks_[c].contained = 1;
    for (const Direction d : kAllDirections) {
      if (!inner(c, d) || !passable(c, d)) continue;
      open_edge(c, d);
      if (!contains(neighbour(c, d))) add_node(neighbour(c, d));
    }
  }
  /// Adds the node across side d of c and the edge to it, double-sided if possible. c is in the tree; the sub-cell
  /// across is not, and the lattice edge to it is free.
  void link(const Cell& c, Direction d) {
    add_node(neighbour(c, d));
    join(c, d);
  }
  /// Adds the edge between two nodes of different trees.
  void join(const Cell& c, Direction d) {
    open_edge(c, d);
    if (inner(c, d) || !double_sided(c, d)) return;
    const Direction along = along_side(c, d);
    open_edge(neighbour(c, along), d);
    if (marks_[c].whole) close_edge(c, along);
    if (marks_[neighbour(c, d)].whole) close_edge(neighbour(c, d), along);
  }

  /// Drives around the tree from `start` on. Calls grow(cell, direction) for every edge out of a sub-cell that is not
  /// open; it may link there and returns whether it did. Calls drive(direction) for every step; false: not possible.
  template <class Grow, class Drive>
  void go_round(const Cell& start, Grow grow, Drive drive) {
    Cell at = start;
    // The corner of the coarse cell beside `start` is outside whatever the tree becomes: from there, counter-clockwise.
    Direction heading = kEast;
    while (!(inner(at, heading) && inner(at, left_of(heading)))) heading = left_of(heading);
    for (;;) {
      bool moved = false;
      for (const Direction d : {right_of(heading), heading, left_of(heading), opposite(heading)}) {
        if (!open(at, d) && !grow(at, d)) continue;
        if ((marks_[at].driven >> d & 1) != 0) return;  // once around
        if (!drive(d)) {
          close_edge(at, d);
          continue;
        }
        marks_[at].driven |= 1 << d;
        at = neighbour(at, d);
        heading = d;
        moved = true;
        break;
      }
      if (!moved) return;
    }
  }

 private:
  // Four bits are a set of directions.
  struct Mark {
    std::uint16_t open : 4 = 0;    // lattice edges of the path around the tree
    std::uint16_t driven : 4 = 0;  // those of them that have been driven in this direction
    std::uint16_t contained : 1 = 0;
    std::uint16_t whole : 1 = 0;  // in a node of four sub-cells
  };
  /// From c to the other sub-cell on side d.
  Direction along_side(const Cell& c, Direction d) const { return first_on_side(c, d) ? left_of(d) : right_of(d); }
  void add_corner(const Cell& c, Direction d, Direction e) {
    Mark& mark = marks_[c];
    mark.contained = mark.whole = 1;
    mark.open |= 1 << d | 1 << e;
  }
  void open_edge(const Cell& c, Direction d) {
    marks_[c].open |= 1 << d;
    marks_[neighbour(c, d)].open |= 1 << opposite(d);
  }
  void close_edge(const Cell& c, Direction d) {
    marks_[c].open &= ~(1 << d);
    marks_[neighbour(c, d)].open &= ~(1 << opposite(d));
  }

  Passable passable_;
  Cell corner_;
  CellMap<Mark> marks_;
};

}  // namespace oxturn
