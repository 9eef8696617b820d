/// A lattice as the lidar shows it: what grid planners drive on without the map.
///
///   LidarCells cells(online_robot, side);
///   CellRobot robot(cells, side);
///
/// A step between cells is passable where the robot is believed to fit along it. What is unknown counts as wall, and
/// may open when more has been seen. A query costs one to the belief.
#pragma once

#include "algorithms/lattice/cell_robot.hpp"
#include "algorithms/online/driver.hpp"

namespace oxturn {

/// Has a node at the start, and runs along the axes.
class LidarCells final : public CellWorld {
 public:
  LidarCells(OnlineRobot& robot, double side);
  bool free(const Cell& c) override;
  bool passable(const Cell& c, Direction d) override;
  bool step(const Cell& c, Direction d, bool tool) override { return go_straight(c, neighbour(c, d), tool); }
  bool straight(const Cell& from, const Cell& to) override;
  bool go_straight(const Cell& from, const Cell& to, bool tool) override;
  Point centre(const Cell& c) const override { return robot_.view().start() + side_ * Point(c.i, c.j); }

 private:
  OnlineRobot& robot_;
  double side_, radius_;
};

}  // namespace oxturn
