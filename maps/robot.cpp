// Is this robot one that can be planned for? And the measures of its footprint.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "geometry/predicates.hpp"
#include "maps/formats.hpp"
#include "maps/map.hpp"
#include "base/text.hpp"

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

/// Counter-clockwise round the origin once, with a left turn at every corner and the origin left of every edge.
void check_footprint(const Robot& robot) {
  const Ring& ring = robot.footprint;
  const auto refuse = [&](const std::string& what) {
    throw std::invalid_argument(fmt::format("robot '{}': footprint {}", robot.name, what));
  };
  const auto text = [](const Point& p) { return fmt::format("({}, {})", to_decimal(p.x()), to_decimal(p.y())); };
  const std::size_t n = ring.size();
  if (n < 3) refuse(fmt::format("has {} corner{}, expected at least 3", n, n == 1 ? "" : "s"));
  for (std::size_t i = 0; i < n; ++i)
    if (!finite(ring[i])) refuse(fmt::format("corner {} is not finite, expected metres", i + 1));
  if (signed_area(ring) < 0) refuse("runs clockwise, expected its corners counter-clockwise");
  double turned = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point &a = ring[(i + n - 1) % n], &b = ring[i], &c = ring[(i + 1) % n];
    if (orientation(a, b, c) <= 0)
      refuse(fmt::format("is not convex at corner {}, {}; expected a left turn at every corner", i + 1, text(b)));
    turned += std::atan2(cross(b - a, c - b), (b - a).dot(c - b));
  }
  if (turned > 3 * kPi) refuse("runs round more than once, expected a simple polygon");
  for (std::size_t i = 0; i < n; ++i)
    if (orientation(ring[i], ring[(i + 1) % n], Point(0, 0)) <= 0)
      refuse(fmt::format("does not hold the robot's centre (0, 0) inside: it lies beyond the edge from {} to {}",
                         text(ring[i]), text(ring[(i + 1) % n])));
  if (robot.tether) refuse("is a polygon, but a tether asks for a round robot; leave one of the two out");
  if (robot.min_turn_radius > 0)
    refuse("is a polygon that never turns, but min_turn_radius is above 0; leave one of the two out");
}

}  // namespace

Ring named_footprint(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::string shape = text.substr(0, colon);
  double width = 0;
  if (colon != std::string::npos) {
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data() + colon + 1, last, width);
    if (error != std::errc{} || end != last || !std::isfinite(width)) width = 0;
  }
  if ((shape != "square" && shape != "octagon") || width <= 0)
    throw std::invalid_argument(fmt::format(
        "footprint is '{}', expected square:WIDTH or octagon:WIDTH in metres, or a list of corners where that can be "
        "written",
        text));
  const double h = width / 2;
  if (shape == "square") return {{h, -h}, {h, h}, {-h, h}, {-h, -h}};
  const double t = h * (std::sqrt(2.0) - 1);
  return {{h, -t}, {h, t}, {t, h}, {-t, h}, {-h, t}, {-h, -t}, {-t, -h}, {t, -h}};
}

double in_radius(const Ring& footprint) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < footprint.size(); ++i) {
    const Point &a = footprint[i], along = footprint[(i + 1) % footprint.size()] - a;
    least = std::min(least, cross(a, along) / along.norm());
  }
  return least;
}

double height(const Robot& robot) {
  if (robot.footprint.empty()) return 2 * robot.radius;
  Box box;
  for (const Point& p : robot.footprint) box.add(p);
  return box.size().y();
}

void check(const Robot& robot) {
  not_negative(robot, "radius", robot.radius, "metres");
  positive(robot, "tool_width", robot.tool_width, "metres");
  positive(robot, "speed", robot.speed, "metres per second");
  positive(robot, "acceleration", robot.acceleration, "metres per second squared");
  positive(robot, "turn_rate", robot.turn_rate, "radians per second");
  not_negative(robot, "min_turn_radius", robot.min_turn_radius, "metres");
  if (!robot.footprint.empty()) check_footprint(robot);
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
