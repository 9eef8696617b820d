// Places by coordinates or by name: what suites and the command line may say for start and anchor.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "maps/map.hpp"
#include "maps/robot.hpp"

namespace oxturn {

/// What the place is for; each has its own names.
///   start   "middle": default_start() · "corner": the place of configuration space farthest to the lower left (least
///           x + y, then least x), in its largest part and with tool_width / 100 to spare
///   anchor  "start": where the robot starts · "wall": the place on free space's boundary nearest to the start, as if
///           the tether came out of a socket there · "corner": the corner of free space nearest to the start of those
///           that can be seen from it
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
std::string to_text(const Location& place);

/// Start and anchor as Problem takes them: empty where nobody says, so that its own rules hold.
struct StartAndAnchor {
  std::optional<Point> start, anchor;
};
/// Works the names out for this map and robot; O(n log n) if a name is used. An anchor by name needs a start: if there
/// is none, it is the middle. A named anchor lies in the closed free space, exactly. Throws std::invalid_argument
/// where the robot fits nowhere; whether given points are good is for Problem to say.
StartAndAnchor resolve(const Map& map, const Robot& robot, const std::optional<Location>& start,
                       const std::optional<Location>& anchor);

}  // namespace oxturn
