/// What turns cost a robot, in metres that it could have driven instead.
///
///   const TurnCost turns(robot);
///   turns(a, b, c);                              // at b, from a to c
///   turns.change(path, change);                  // by how much a move changes the sum
///
/// The robot rounds corners within a tenth of the tool's width, and drives no faster there than turn_rate times the
/// radius of the curve: it brakes, and accelerates again. O(1).
#pragma once

#include "algorithms/improve/moves.hpp"
#include "maps/robot.hpp"

namespace oxturn {

class TurnCost {
 public:
  explicit TurnCost(const Robot& robot) : robot_(robot) {}
  double operator()(const Point& a, const Point& b, const Point& c) const;
  double total(const Polyline& points) const;
  double change(const VertexPath& path, const Change& change) const;

 private:
  Robot robot_;
};

}  // namespace oxturn
