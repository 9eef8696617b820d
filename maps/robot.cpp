// Is this robot one that can be planned for?
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "maps/formats.hpp"
#include "maps/map.hpp"

namespace oxturn {
namespace {

void positive(const Robot& robot, const char* member, double value, const char* unit) {
  if (!std::isfinite(value) || value <= 0)
    throw std::invalid_argument(
        fmt::format("robot '{}': {} is {}, expected {} above 0", robot.name, member, to_decimal(value), unit));
}

void not_negative(const Robot& robot, const char* member, double value, const char* unit) {
  if (!std::isfinite(value) || value < 0)
    throw std::invalid_argument(
        fmt::format("robot '{}': {} is {}, expected {} of at least 0", robot.name, member, to_decimal(value), unit));
}

}  // namespace

void check(const Robot& robot) {
  not_negative(robot, "radius", robot.radius, "metres");
  positive(robot, "tool_width", robot.tool_width, "metres");
  positive(robot, "speed", robot.speed, "metres per second");
  positive(robot, "acceleration", robot.acceleration, "metres per second squared");
  positive(robot, "turn_rate", robot.turn_rate, "radians per second");
  not_negative(robot, "min_turn_radius", robot.min_turn_radius, "metres");
  if (robot.tether) positive(robot, "tether.length", robot.tether->length, "metres");
  if (robot.lidar) {
    positive(robot, "lidar.range", robot.lidar->range, "metres");
    if (robot.lidar->rays < 1)
      throw std::invalid_argument(
          fmt::format("robot '{}': lidar.rays is {}, expected at least 1", robot.name, robot.lidar->rays));
  }
}

}  // namespace oxturn
