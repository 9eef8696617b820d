/// Robots and settings as JSON. Private to maps/formats.
///
///   const Robot robot = read_robot({json["robot"], "yard.geojson: robot"}, "yard.geojson");
///   text += robot_text(robot);
#pragma once

#include "base/parameters.hpp"
#include "maps/formats/json.hpp"
#include "maps/robot.hpp"

namespace oxturn {

/// The members of an object as settings. Null is left out; a list of points [x, y] becomes the text "x y; x y".
Settings read_settings(const JsonAt& at);
std::string settings_text(const Settings& settings);

/// Members of groups ("tether": {"length": 40}) are the parameters of names like tether_length. Throws for unknown
/// members and for robots that check() refuses; `file` is named.
Robot read_robot(const JsonAt& at, const std::string& file);
std::string robot_text(const Robot& robot);

}  // namespace oxturn
