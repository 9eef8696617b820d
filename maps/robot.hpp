/// The robot: its size, its tool, how it moves, and what it may drag or carry.
///
///   Robot robot;
///   apply_settings("robot 'mower'", robot_parameters(), {{"radius", 0.3}, {"tool_width", 0.5}}, robot);
///   check(robot);
#pragma once

#include <optional>

#include "base/parameters.hpp"
#include "geometry/region.hpp"

namespace oxturn {

struct Tether {
  double length = 0;  // metres, > 0
  double reach = 0;   // > 0 in place of a length: that many times the geodesic distance of the farthest point
                      // (Problem works it out; the robot that it hands out has a length)
  double sharp_angle = kPi * 3 / 4;  // radians in (0, pi]: a heading turned farther than this from "straight away from
                                     // the tether's pull" counts as sharp
};
struct Lidar {
  double range = 0;  // metres, > 0
  int rays = 360;    // evenly spaced from heading 0, >= 1
  double noise = 0;  // metres along the ray, standard deviation, >= 0
};

struct Robot {
  std::string name = "disc";
  double radius = 0.2;         // metres, >= 0; with a footprint Problem puts in_radius(footprint) here
  double tool_width = 0.4;     // metres, > 0
  double speed = 0.5;          // m/s, > 0
  double acceleration = 0.5;   // m/s^2, > 0
  double turn_rate = 1.5;      // rad/s, > 0
  double min_turn_radius = 0;  // metres, >= 0; 0: turns on the spot
  bool reverse = false;        // with min_turn_radius: it can drive backwards too
  std::optional<Tether> tether;
  std::optional<Lidar> lidar;
  /// Empty: a disc. Else a convex polygon about the robot's centre, which lies strictly inside; counter-clockwise,
  /// metres. Its orientation is fixed: such a robot drives in all directions without turning.
  Ring footprint = {};
};

/// The one description of a robot. Command line, suites, problem files, hashes and listings are made from it. Members
/// of `tether` and `lidar` are called tether_length, lidar_range, ...: files may write them as a table of the group's
/// name.
const std::vector<Parameter<Robot>>& robot_parameters();
/// Groups of parameters that a robot may lack as a whole: "tether", "lidar".
const std::vector<std::string>& robot_groups();
/// The parameter's group, or "" ("tether" of tether_length).
std::string robot_group(const std::string& parameter);

/// Writes `settings` over the robot's members. A tether's length and reach replace each other, and so do radius and
/// footprint. Throws std::invalid_argument for an unknown name, a wrong type or a value out of range.
void change(Robot& robot, const Settings& settings);
/// What change() needs to make this robot of a default one: all plain parameters, and of a group that the robot has the
/// values that are not its defaults.
Settings settings_of(const Robot& robot);
/// Throws std::invalid_argument in one sentence for values out of range or that do not go together.
void check(const Robot& robot);
/// Canonical text of everything but the name: equal for robots that behave alike.
std::string canonical_text(const Robot& robot);

/// "disc" (an empty ring); "square:0.5" or "octagon:0.5": regular, two sides parallel to each axis, so wide; or
/// vertices "0.5 0; 0 0.5; -0.5 0; 0 -0.5". Throws a sentence for anything else.
Ring parse_footprint(const std::string& text);
/// The largest disc about the centre that lies inside the footprint.
double in_radius(const Ring& footprint);
/// From the lowest to the highest point of the robot, metres.
double height(const Robot& robot);

}  // namespace oxturn
