#include "maps/locations.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <tuple>

#include "base/text.hpp"
#include "base/throw_invalid.hpp"
#include "maps/problem.hpp"

namespace oxturn {
namespace {

const char* word(LocationKind of) { return of == LocationKind::start ? "start" : "anchor"; }

[[noreturn]] void refuse(LocationKind of, const std::string& text) {
  throw_invalid("{} is '{}', expected X,Y: two finite numbers in metres, or one of: {}", word(of), text,
                fmt::join(location_names(of), ", "));
}

Point lower_left(const Map& map, Robot robot) {
  robot.tether.reset();  // the robot without a tether
  // So that lanes and grids that begin there do not touch the walls.
  const double spare = robot.tool_width / 100;
  if (robot.footprint.empty()) {
    robot.radius += spare;
  } else {
    const double larger = 1 + spare / in_radius(robot.footprint);  // moves every side out by as much at least
    for (Point& p : robot.footprint) p *= larger;
  }
  const Problem loose(map, robot);
  std::optional<Point> best;
  const auto key = [](const Point& p) { return std::tuple(p.x() + p.y(), p.x()); };
  for_each_ring(loose.configuration_space(), [&](const Ring& ring) {
    for (const Point& p : ring)
      if (!best || key(p) < key(*best)) best = p;
  });
  return *best;
}

/// The nearest point of a wall may be rounded to either side of it: moved back towards the start until it is inside.
Point nearest_wall(const EdgeIndex& walls, const Point& start) {
  const Point nearest = walls.nearest(start)->point;
  Point inside = nearest;
  for (double share = std::numeric_limits<double>::epsilon(); share < 1 && !walls.contains(inside); share *= 2)
    inside = lerp(nearest, start, share);
  return inside;
}

Point nearest_corner(const Map& map, const EdgeIndex& walls, const Point& start) {
  std::vector<Point> corners;
  for_each_ring(map.free, [&](const Ring& ring) { corners.insert(corners.end(), ring.begin(), ring.end()); });
  std::sort(corners.begin(), corners.end(), [&](const Point& a, const Point& b) {
    return std::tuple((a - start).squaredNorm(), a.x(), a.y()) < std::tuple((b - start).squaredNorm(), b.x(), b.y());
  });
  for (const Point& corner : corners)
    if (walls.contains(start, corner)) return corner;
  // From inside, a corner can always be seen; a start in a wall is for Problem to refuse.
  return corners.front();
}

}  // namespace

const std::vector<std::string>& location_names(LocationKind of) {
  static const std::vector<std::string> starts{"middle", "corner"}, anchors{"start", "wall", "corner"};
  return of == LocationKind::start ? starts : anchors;
}

Location named_location(LocationKind of, const std::string& name) {
  const auto& names = location_names(of);
  if (std::find(names.begin(), names.end(), name) == names.end()) refuse(of, name);
  return {name};
}

Location parse_location(LocationKind of, const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return named_location(of, text);
  const std::string_view all = text;
  const auto x = parse_number(all.substr(0, comma)), y = parse_number(all.substr(comma + 1));
  if (!x || !y) refuse(of, text);
  return {"", {*x, *y}};
}

std::string to_text(const Location& location) {
  if (!location.name.empty()) return location.name;
  return fmt::format("{} {}", to_decimal(location.point.x()), to_decimal(location.point.y()));
}

StartAndAnchor resolve(const Map& map, const Robot& robot, const std::optional<Location>& start,
                       const std::optional<Location>& anchor) {
  StartAndAnchor found;
  if (start) {
    found.start = start->name.empty()       ? start->point
                  : start->name == "corner" ? lower_left(map, robot)
                                            : default_start(map, robot);
  }
  if (!anchor) return found;
  if (anchor->name.empty()) {
    found.anchor = anchor->point;
    return found;
  }
  if (!found.start) found.start = default_start(map, robot);
  const Point& from = *found.start;
  if (anchor->name == "start" || !finite(from) || map.free.empty()) {
    found.anchor = from;
    return found;
  }
  const EdgeIndex walls(map.free);
  found.anchor = anchor->name == "wall" ? nearest_wall(walls, from) : nearest_corner(map, walls, from);
  return found;
}

}  // namespace oxturn
