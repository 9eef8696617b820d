#include "algorithms/online/lidar_cells.hpp"

namespace oxturn {

// The radius less the problem's tolerance: rounding must not close a passage as wide as the robot.
LidarCells::LidarCells(OnlineRobot& robot, double side)
    : robot_(robot),
      side_(side),
      radius_(std::max(0.0, robot.view().robot().radius - 1e-6 * robot.view().robot().tool_width)) {}

bool LidarCells::free(const Cell& c) { return robot_.view().belief().free_for(centre(c), centre(c), radius_); }

bool LidarCells::passable(const Cell& c, Direction d) { return straight(c, neighbour(c, d)); }

bool LidarCells::straight(const Cell& from, const Cell& to) {
  return robot_.view().belief().free_for(centre(from), centre(to), radius_);
}

bool LidarCells::go_straight(const Cell& from, const Cell& to, bool tool) {
  if (robot_.go({{centre(to)}, tool})) return true;
  // Stopped on the way by what it saw. What lies behind was free when the robot came, so it goes back.
  robot_.go({{centre(from)}, tool});
  return false;
}

}  // namespace oxturn
