/// Start and anchor by coordinates or by name: what suites and the command line accept.
///
///   const auto start = parse_location(LocationKind::start, "corner");
///   const StartAndAnchor at = resolve(map, robot, start, {});
#pragma once

#include <optional>

#include "maps/map.hpp"
#include "maps/robot.hpp"

namespace oxturn {

/// What the location is for; each kind has its own names.
///   start   "middle": default_start(); "corner": the point of configuration space farthest to the lower left (least
///           x + y, then least x), in its largest component and with tool_width / 100 to spare
///   anchor  "start": where the robot starts; "wall": the point on the boundary of free space nearest to the start, as
///           if the tether came out of a socket there; "corner": the vertex of free space nearest to the start among
///           those visible from it
enum class LocationKind { start, anchor };
const std::vector<std::string>& location_names(LocationKind of);

struct Location {
  std::string name;  // empty: the point
  Point point{0, 0};
  bool operator==(const Location&) const = default;
};

/// "2.5,1" or a name. Throws "anchor is 'wal', expected X,Y in metres or one of: start, wall, corner".
Location parse_location(LocationKind of, const std::string& text);
/// The same for a name alone; throws likewise.
Location named_location(LocationKind of, const std::string& name);
/// The name, or "2.5 1".
std::string to_text(const Location& location);

/// Start and anchor as Problem takes them: empty where not given, so that its own rules hold.
struct StartAndAnchor {
  std::optional<Point> start, anchor;
};
/// Resolves the names for this map and robot; O(n log n) if a name is used. An anchor by name needs a start: by default
/// the middle. A named anchor lies exactly in the closed free space. Throws std::invalid_argument if the robot fits
/// nowhere; Problem checks given points.
StartAndAnchor resolve(const Map& map, const Robot& robot, const std::optional<Location>& start,
                       const std::optional<Location>& anchor);

}  // namespace oxturn
