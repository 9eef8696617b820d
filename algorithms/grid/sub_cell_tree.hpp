// A spanning tree of coarse cells as its sub-cells see it, and the way round it: the shared part of spanning tree coverage
// that grows while it is driven, or that takes in partly occupied coarse cells.
//
// A node of the tree is what hangs together of a coarse cell's free sub-cells: the whole cell, three, two or one of
// them; two diagonal ones are two nodes. An edge of the tree is double-sided where both ways across fit (the robot goes
// out on one and comes home on the other, and does not drive the cell's side between them), else single-sided: out and
// home by the one way. What may be driven is kept as `open` ways between sub-cells. The robot keeps to the right:
// at every sub-cell the first open way out of right, ahead, left, back. So it goes round the tree, which stays at its
// left, and looks over every side of every sub-cell once.
//
// Source      Gabriely & Rimon, ICRA 2001; after "Competitive on-line coverage of grid environments by a mobile robot",
//             Computational Geometry 24, 2003
// Guarantee   the round is closed and drives (n + 2 s + t - p) steps for n sub-cells, s single-sided edges, t nodes of
//             three sub-cells and p nodes of one. A node is one edge from its parent, so that is at most n + m for the m
//             sub-cells that share a point with a blocked one: a node of 1, 2, 3 sub-cells has as many of them and pays
//             1, 2, 3 more than n for itself and its single-sided edge; a whole one pays 2 only where a sub-cell facing
//             it is blocked, which then touches two of its own. Ways blocked between free sub-cells count alike.
// Complexity  O(1) a question, a link and a step; 2 bytes a sub-cell of the window
#pragma once

#include <array>
#include <cstdint>

#include "algorithms/lattice/cell_map.hpp"

namespace oxturn {

/// `Passable`: bool(const Cell&, Direction), the straight way between two sub-cell centres is free.
template <class Passable>
class SubCellTree {
 public:
  /// `corner`: the lower left sub-cell of some coarse cell.
  SubCellTree(Passable passable, const Cell& corner) : passable_(std::move(passable)), corner_(corner) {}

  bool passable(const Cell& c, Direction d) const { return passable_(c, d); }
  bool holds(const Cell& c) const { return (ways_.get(c) & kHeld) != 0; }
  bool open(const Cell& c, Direction d) const { return (ways_.get(c) >> d & 1) != 0; }
  /// The lower left sub-cell of c's coarse cell.
  Cell base(const Cell& c) const { return {c.i - ((c.i - corner_.i) & 1), c.j - ((c.j - corner_.j) & 1)}; }
  bool inner(const Cell& c, Direction d) const {
    return d == kEast || d == kWest ? ((c.i - corner_.i) & 1) == (d == kWest)
                                    : ((c.j - corner_.j) & 1) == (d == kSouth);
  }
  /// Round the coarse cell counter-clockwise each side has a first sub-cell and a second.
  bool first_on_side(const Cell& c, Direction d) const { return inner(c, left_of(d)); }
  /// All four sub-cells are free and the ways between them.
  bool whole(const Cell& c) const {
    const Cell b = base(c), east = neighbour(b, kEast), north = neighbour(b, kNorth);
    return passable(b, kEast) && passable(b, kNorth) && passable(east, kNorth) && passable(north, kEast);
  }
  /// An edge out of c's coarse cell over its side d, of which c is a part, would be double-sided.
  bool two_ways(const Cell& c, Direction d) const {
    const Direction along = first_on_side(c, d) ? left_of(d) : right_of(d);
    return passable(c, d) && passable(c, along) && passable(neighbour(c, along), d) && passable(neighbour(c, d), along);
  }

  /// The node that c belongs to, alone for the time being.
  void add_node(const Cell& c) {
    if (whole(c)) {
      const Cell b = base(c), east = neighbour(b, kEast), north = neighbour(b, kNorth);
      mark(b, kHeld | kWhole | 1 << kEast | 1 << kNorth);
      mark(east, kHeld | kWhole | 1 << kWest | 1 << kNorth);
      mark(north, kHeld | kWhole | 1 << kEast | 1 << kSouth);
      mark(neighbour(north, kEast), kHeld | kWhole | 1 << kWest | 1 << kSouth);
      return;
    }
    mark(c, kHeld);
    for (const Direction d : kAllDirections) {
      if (!inner(c, d) || !passable(c, d)) continue;
      open_way(c, d);
      if (!holds(neighbour(c, d))) add_node(neighbour(c, d));
    }
  }
  /// Adds the node across c's side d, and the edge to it: double-sided if that can be. c is in the tree, what is across
  /// is not and can be driven to.
  void link(const Cell& c, Direction d) {
    const Cell across = neighbour(c, d);
    add_node(across);
    join(c, d);
  }
  /// The edge alone: both nodes are there and in different trees.
  void join(const Cell& c, Direction d) {
    open_way(c, d);
    if (inner(c, d) || !two_ways(c, d)) return;
    const Direction along = first_on_side(c, d) ? left_of(d) : right_of(d);
    open_way(neighbour(c, along), d);
    if ((ways_[c] & kWhole) != 0) close_way(c, along);
    if ((ways_[neighbour(c, d)] & kWhole) != 0) close_way(neighbour(c, d), along);
  }

  /// Round the tree from `start`: calls grow(cell, direction) for every way out of a sub-cell that is not open (it may
  /// link it, and tells whether it did), drive(direction) for every step: false if that could not be.
  template <class Grow, class Drive>
  void round(const Cell& start, Grow grow, Drive drive) {
    Cell at = start;
    // The corner of the coarse cell beside `start` is outside whatever the tree is: from there on, counter-clockwise.
    Direction heading = kEast;
    while (!(inner(at, heading) && inner(at, left_of(heading)))) heading = left_of(heading);
    for (;;) {
      bool moved = false;
      for (const Direction d : {right_of(heading), heading, left_of(heading), opposite(heading)}) {
        if (!open(at, d) && !grow(at, d)) continue;
        if ((ways_[at] >> (d + kDrivenShift) & 1) != 0) return;  // round
        if (!drive(d)) {
          close_way(at, d);
          continue;
        }
        mark(at, 1 << (d + kDrivenShift));
        at = neighbour(at, d);
        heading = d;
        moved = true;
        break;
      }
      if (!moved) return;
    }
  }

 private:
  static constexpr int kHeld = 1 << 4, kWhole = 1 << 5, kDrivenShift = 8;
  void mark(const Cell& c, int bits) { ways_[c] = static_cast<std::uint16_t>(ways_[c] | bits); }
  void open_way(const Cell& c, Direction d) {
    mark(c, 1 << d);
    mark(neighbour(c, d), 1 << opposite(d));
  }
  void close_way(const Cell& c, Direction d) {
    ways_[c] = static_cast<std::uint16_t>(ways_[c] & ~(1 << d));
    ways_[neighbour(c, d)] = static_cast<std::uint16_t>(ways_[neighbour(c, d)] & ~(1 << opposite(d)));
  }

  Passable passable_;
  Cell corner_;
  CellMap<std::uint16_t> ways_;
};

}  // namespace oxturn
