/// Exploration: to the nearest position from which some frontier can be seen, until none is left that can be reached.
///
///   Explorer explorer;
///   while (const auto motion = explorer.next(robot.view())) robot.go(*motion);
///
/// A frontier is a free cell next to unknown ones without a wall nearby; frontiers that touch are one. A viewpoint of a
/// frontier is a position of the robot with half of the frontier in sight and near enough to be believed. What stays a
/// frontier although it was looked at must be looked at from half as far the next time, and is given up when the robot
/// has been next to it. So exploration ends.
/// Decisions   1. Cells of radius / 8 and one world of that resolution (finer where the robot would not fit into it).
///             2. A frontier shorter than half the robot's radius is left to the coverage path, which passes it anyway.
///             3. Frontiers beyond the tether's reach are ignored.
///             4. The drive to the nearest viewpoint is one whole motion, so the robot does not go back and forth.
/// A call O(cells of the window) and, without a tether, one shortest path.
#pragma once

#include <map>
#include <utility>

#include "algorithms/online/driver.hpp"

namespace oxturn {

class Explorer {
 public:
  /// The next motion; nullopt: all that can be reached has been seen. With a tether every motion keeps its length.
  std::optional<Motion> next(const View& view);

 private:
  std::optional<Problem> world(const View& view);
  double& look_from(const BitGrid& grid, int i, int j, double farthest);
  BitGrid open_cells(const View& view, const Belief::Cells& cells);

  int level_ = Belief::kCoarsest;
  std::map<std::pair<std::int64_t, std::int64_t>, double> look_from_;  // cell -> how near it must be looked at from
  double look_cell_ = 0;                                               // side of these cells
  Point look_origin_{0, 0};
};

}  // namespace oxturn
