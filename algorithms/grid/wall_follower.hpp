/// Follows walls where driving from cell to cell leaves something uncovered beside them: through partial cells, which
/// meet free space but whose centre the robot cannot occupy, and through free cells whose centre is away from the wall.
///
///   WallFollower walls(problem, robot);
///   while (walk.go_to([&](const Cell& c) { return walls.any_left(c); })) walls.follow_on(walk, true);
///
/// The walls here are the edges of configuration space, so the robot touches the real ones all along. They are cut at
/// cell borders into sections. From a cell beside a section the robot drives straight to it and along the wall, as long
/// as there are free cells beside the wall by which it can come back on the lattice. If the wall has been followed in
/// that direction, it turns to the other one: a wall is followed in long stretches, not cell by cell.
///
///     +-----+-----+-----+
///     |     |     |     |     R  where the robot begins and ends
///     |  R  |  c  |  c  |     c  cells by which it comes back
///     +-----+-----+-----+
///     |==========#|     |     =  followed sections of wall, in partial cells
///     +-----+-----+-----+
///
/// O(vertices + cells that walls cross) to build; following costs what is driven.
#pragma once

#include <vector>

#include "algorithms/lattice/cell_walk.hpp"

namespace oxturn {

class WallFollower {
 public:
  /// For a robot on the true map. Both must outlive it.
  WallFollower(const Problem& problem, const CellRobot& robot);

  /// There is an unfollowed section in c or the eight cells around it, and follow_on() has not failed there.
  bool any_left(const Cell& c) const;
  /// Follows the unfollowed sections of `cell`, which is the robot's or beside it, if they can be seen, and the wall
  /// beyond. `left`: with the wall on the left where there is a choice. Ends where it began.
  void follow(CellWalk& walk, const Cell& cell, bool left);
  /// Follows one unfollowed section in sight in the nine cells, and the wall beyond; ends there. False: there is none.
  bool follow_on(CellWalk& walk, bool left);
  /// Metres driven along walls.
  double length() const { return length_; }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  /// The part of a wall in one cell.
  struct Section {
    std::uint32_t begin, end;  // of points_
    Cell cell;
    std::uint32_t next = kNone, previous = kNone;  // along the wall, if it continues there
    std::uint32_t next_in_cell = kNone;
    bool followed = false;
  };
  /// A drive along the wall, and the cells by which the robot can come back to the lattice.
  struct Excursion {
    Polyline line;
    std::vector<Cell> return_cells;
  };
  void add_ring(const Ring& ring);
  void begin_section(const Point& at, const Cell& cell, bool continues);
  bool worth_following(const Point& a, const Point& b, const Cell& cell) const;
  void close_ring(std::uint32_t first, const Point& end, bool continues);
  Cell in_graph(const Cell& c) const { return {c.i + lattice_.first.i, c.j + lattice_.first.j}; }
  std::uint32_t first_in(const Cell& c) const { return first_.get(c) - 1; }  // wraps to kNone
  std::uint32_t after(std::uint32_t section, bool left) const {
    return left ? sections_[section].previous : sections_[section].next;
  }
  bool unfollowed(std::uint32_t section) const { return section != kNone && !sections_[section].followed; }
  bool any_unfollowed_in(const Cell& c) const;
  std::optional<std::uint32_t> nearest_point_in_sight(const Section& section, const Point& eye) const;
  std::optional<std::vector<Cell>> cells_to(const Cell& from, const Cell& wall) const;
  std::optional<std::vector<Cell>> follow(CellWalk& walk, std::uint32_t section, bool left);
  Excursion excursion(const Cell& from, std::uint32_t section, std::uint32_t first_point, bool left);
  Polyline straightened(const Polyline& line) const;

  const Problem& problem_;
  const CellRobot& robot_;
  const CellRobot::Lattice lattice_;
  std::vector<Point> points_;
  std::vector<Section> sections_;
  CellMap<std::uint32_t> first_;  // of each cell: its first section's number plus one
  CellMap<std::uint8_t> tried_;
  double length_ = 0;
};

}  // namespace oxturn
