/// From a map and a robot to the connected components of configuration space. Internal to maps/.
///
///   const Region all = eroded(map, map.free, robot);
///   const Polygon* component = component_at(all, start, tolerance);   // nullptr: the robot does not fit there
#pragma once

#include <optional>

#include "maps/map.hpp"
#include "maps/robot.hpp"

namespace oxturn {

/// Everywhere the robot's centre may be, in all connected components. Throws std::invalid_argument if it fits nowhere.
Region eroded(const Map& map, const Region& free, const Robot& robot);

/// "radius 0.2" or "footprint of 8 vertices", for messages.
std::string size_text(const Robot& robot);

/// The component that holds p, or the nearest of those within `tolerance` metres; nullptr if there is none. O(n).
const Polygon* component_at(const Region& all, const Point& p, double tolerance);
bool holds(const Region& region, const Point& p, double tolerance);

/// A point of `all` next to the one nearest to p, with as few decimals as keep it inside, so that it can be typed
/// again.
Point nearest_point_inside(const Region& all, const Point& p, double tool_width);

/// Where a robot starts by default: at the roomiest point of free space (Mesh::roomiest_point) that lies in the largest
/// component (the first of equals), or at the component's own if none does. With a target area (nullptr: none): the
/// same of that, if the robot fits there, or else within half a tool's width of it. Neither free space nor target area
/// has arcs, so their triangulation takes a tenth of the time of the component's.
Point find_default_start(const Region& all, const Region& free, const Region* target_area, double tool_width);

}  // namespace oxturn
