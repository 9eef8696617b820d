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
  if (robot.tether) {
    const Tether& tether = *robot.tether;
    if (tether.reach != 0)
      positive(robot, "tether.reach", tether.reach, "a multiple of the farthest distance");
    else
      positive(robot, "tether.length", tether.length, "metres");
    if (tether.reach != 0 && tether.length != 0)
      throw std::invalid_argument(
          fmt::format("robot '{}': tether has a length and a reach, expected one of the two", robot.name));
    if (!(tether.sharp_angle > 0 && tether.sharp_angle <= kPi))
      throw std::invalid_argument(
          fmt::format("robot '{}': tether.sharp_angle is {}, expected radians above 0, at most pi", robot.name,
                      to_decimal(tether.sharp_angle)));
  }
  if (robot.lidar) {
    positive(robot, "lidar.range", robot.lidar->range, "metres");
    if (robot.lidar->rays < 1)
      throw std::invalid_argument(
          fmt::format("robot '{}': lidar.rays is {}, expected at least 1", robot.name, robot.lidar->rays));
    not_negative(robot, "lidar.noise", robot.lidar->noise, "metres");
  }
}

}  // namespace oxturn
