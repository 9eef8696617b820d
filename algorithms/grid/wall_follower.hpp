// Follows walls where driving from cell to cell leaves something beside them: through partial cells, those that meet
// free space but in whose centre the robot cannot stand, and through free cells whose centre is away from the wall.
//
// The walls here are the edges of configuration space, so the robot touches the real ones all the way. They are cut at
// cell borders into stretches. From a cell beside one the robot drives straight to it and along it, from cell to cell,
// as long as there are free cells beside by which it can come back on the lattice; and so it comes back.
//
// Complexity  O(corners + cells that walls cross) to build; following costs what is driven
#pragma once

#include <vector>

#include "algorithms/lattice/cell_walk.hpp"

namespace oxturn {

class WallFollower {
 public:
  /// For a robot on the true map. Both must outlive it.
  WallFollower(const Problem& problem, const CellRobot& robot);

  /// Is there anything unfollowed in the eight cells about c that has not been tried from c?
  bool any_left(const Cell& c) const;
  /// If that cell beside the robot has an unfollowed stretch in sight: along it, with the wall on that side, and back to
  /// where the robot stood.
  void follow(CellWalk& walk, const Cell& partial, bool wall_on_left);
  /// All that is about the robot's cell; tried from here then.
  void follow_all(CellWalk& walk, bool wall_on_left);
  double length() const { return length_; }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  struct Stretch {
    std::uint32_t begin, end;  // of points_
    Cell cell;
    std::uint32_t next = kNone, previous = kNone;  // along the wall, if that goes on there
    std::uint32_t next_in_cell = kNone;
    bool followed = false;
  };
  void add_ring(const Ring& ring);
  bool partial(const Cell& c) const;
  std::uint32_t first_in(const Cell& c) const { return first_.get(c) - 1; }  // 0: none
  bool open_in(const Cell& c) const;
  bool passable(const Cell& c, Direction d) const;
  std::optional<std::vector<Cell>> beside(const Cell& from, const Cell& wall) const;
  bool follow(CellWalk& walk, std::uint32_t stretch, bool wall_on_left);

  const Problem& problem_;
  const CellRobot& robot_;
  std::vector<Point> points_;
  std::vector<Stretch> stretches_;
  CellMap<std::uint32_t> first_;
  CellMap<std::uint8_t> tried_;
  double length_ = 0;
};

}  // namespace oxturn
