#include "maps/robot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/math.hpp"
#include "base/text.hpp"
#include "base/throw_invalid.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

constexpr double kLargest = 1e9;  // of any measure, in its unit

std::string owner_of(const Robot& robot) { return fmt::format("robot '{}'", robot.name); }

/// "x y; x y; ...", numbers in their shortest form.
std::string vertices_text(const Ring& ring) {
  std::string text;
  for (const Point& p : ring)
    text += fmt::format("{}{} {}", text.empty() ? "" : "; ", to_decimal(p.x()), to_decimal(p.y()));
  return text;
}

/// A member of an optional group: reading it from a robot without the group gives its default, writing it makes the
/// group.
template <class Group, class T>
Parameter<Robot> grouped(std::string name, std::optional<Group> Robot::*group, T Group::*member, Range range,
                         std::string help) {
  return {{std::move(name), {}, range, {}, std::move(help)},
          [=](const Robot& robot) { return value_of((robot.*group).value_or(Group{}).*member); },
          [=](Robot& robot, const Value& value) {
            if (!(robot.*group)) (robot.*group).emplace();
            (*(robot.*group)).*member = value_as<T>(value);
          }};
}

bool has_group(const Robot& robot, const std::string& group) {
  return group.empty() || (group == "tether" ? robot.tether.has_value() : robot.lidar.has_value());
}

/// Counter-clockwise round the origin once, with a left turn at every vertex and the origin left of every edge.
void check_footprint(const Robot& robot) {
  const Ring& ring = robot.footprint;
  const auto refuse = [&](const std::string& what) { throw_invalid("robot '{}': footprint {}", robot.name, what); };
  const std::size_t n = ring.size();
  if (n < 3) refuse(fmt::format("has {} {}, expected at least 3", n, n == 1 ? "vertex" : "vertices"));
  for (std::size_t i = 0; i < n; ++i)
    if (!finite(ring[i])) refuse(fmt::format("vertex {} is not finite, expected metres", i + 1));
  if (signed_area(ring) < 0) refuse("runs clockwise, expected its vertices counter-clockwise");
  double turned = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point &a = ring[(i + n - 1) % n], &b = ring[i], &c = ring[(i + 1) % n];
    if (orientation(a, b, c) <= 0)
      refuse(fmt::format("is not convex at vertex {}, {}; expected a left turn at every vertex", i + 1, to_text(b)));
    turned += math::atan2(cross(b - a, c - b), (b - a).dot(c - b));
  }
  if (turned > 3 * kPi) refuse("runs round more than once, expected a simple polygon");
  for_each_edge(ring, [&](const Point& a, const Point& b) {
    if (orientation(a, b, Point(0, 0)) <= 0)
      refuse(fmt::format("does not hold the robot's centre (0, 0) inside: it lies beyond the edge from {} to {}",
                         to_text(a), to_text(b)));
  });
  if (robot.tether) refuse("is a polygon, but a tether needs a round robot; leave one of the two out");
  if (robot.min_turn_radius > 0)
    refuse("is a polygon that never turns, but min_turn_radius is above 0; leave one of the two out");
}

/// "0.5 0; 0 0.5; ..."; empty if it is not that.
Ring parse_vertices(const std::string& text) {
  Ring ring;
  std::size_t from = 0;
  while (from <= text.size()) {
    const std::size_t end = std::min(text.find(';', from), text.size());
    std::string pair = text.substr(from, end - from);
    while (!pair.empty() && pair.front() == ' ') pair.erase(0, 1);
    while (!pair.empty() && pair.back() == ' ') pair.pop_back();
    const std::size_t space = pair.find(' ');
    if (space == std::string::npos) return {};
    const auto x = parse_number(std::string_view(pair).substr(0, space));
    const auto y = parse_number(std::string_view(pair).substr(space + 1));
    if (!x || !y) return {};
    ring.emplace_back(*x, *y);
    from = end + 1;
  }
  return ring;
}

}  // namespace

const std::vector<Parameter<Robot>>& robot_parameters() {
  static const std::vector<Parameter<Robot>> all{
      {"name", &Robot::name, {}, "what tables call it"},
      {"radius", &Robot::radius, Range{0, kLargest}, "metres, of the robot's disc"},
      {{"footprint",
        {},
        {},
        {},
        "disc, square:WIDTH, octagon:WIDTH, or vertices \"x y; x y; ...\" of a convex polygon, counter-clockwise, "
        "metres"},
       [](const Robot& robot) -> Value {
         return robot.footprint.empty() ? std::string("disc") : vertices_text(robot.footprint);
       },
       [](Robot& robot, const Value& value) { robot.footprint = parse_footprint(std::get<std::string>(value)); }},
      {"tool_width", &Robot::tool_width, Range{0, kLargest, true}, "metres, width of the swath that it covers"},
      {"speed", &Robot::speed, Range{0, kLargest, true}, "metres per second"},
      {"acceleration", &Robot::acceleration, Range{0, kLargest, true}, "metres per second squared"},
      {"turn_rate", &Robot::turn_rate, Range{0, kLargest, true}, "radians per second"},
      {"min_turn_radius", &Robot::min_turn_radius, Range{0, kLargest}, "metres; 0: turns on the spot"},
      {"reverse", &Robot::reverse, "with min_turn_radius above 0: it can drive backwards too"},
      grouped("tether_length", &Robot::tether, &Tether::length, Range{0, kLargest}, "metres of tether"),
      grouped("tether_reach", &Robot::tether, &Tether::reach, Range{0, kLargest},
              "in place of a length: as a multiple of the geodesic distance from the anchor to the farthest point"),
      grouped("tether_sharp_angle", &Robot::tether, &Tether::sharp_angle, Range{0, kPi, true},
              "radians from straight away from the pull; a larger angle counts as sharp"),
      grouped("lidar_range", &Robot::lidar, &Lidar::range, Range{0, kLargest, true},
              "metres that the lidar sees; without it the robot has none"),
      grouped("lidar_rays", &Robot::lidar, &Lidar::rays, Range{1, 1e6},
              "number of rays, evenly spaced, the first at heading 0"),
      grouped("lidar_noise", &Robot::lidar, &Lidar::noise, Range{0, kLargest},
              "standard deviation along the ray, metres"),
  };
  return all;
}

const std::vector<std::string>& robot_groups() {
  static const std::vector<std::string> groups{"tether", "lidar"};
  return groups;
}

std::string robot_group(const std::string& parameter) {
  for (const std::string& group : robot_groups())
    if (parameter.starts_with(group + "_")) return group;
  return "";
}

void change(Robot& robot, const Settings& settings) {
  if (settings.contains("tether_length") || settings.contains("tether_reach")) {
    if (!robot.tether) robot.tether.emplace();
    robot.tether->length = robot.tether->reach = 0;
  }
  if (settings.contains("radius")) robot.footprint.clear();
  const auto name = settings.find("name");
  const std::string* given = name != settings.end() ? std::get_if<std::string>(&name->second) : nullptr;
  const std::string owner = given != nullptr ? fmt::format("robot '{}'", *given) : owner_of(robot);
  if (settings.contains("radius") && settings.contains("footprint"))
    throw_invalid("{} has a radius and a footprint, expected one of the two", owner);
  apply_settings(owner, robot_parameters(), settings, robot);
}

Settings settings_of(const Robot& robot) {
  const Robot plain;
  Settings all;
  for (const Parameter<Robot>& parameter : robot_parameters()) {
    const std::string& name = parameter.info.name;
    const std::string group = robot_group(name);
    if (!has_group(robot, group)) continue;
    if (name == (robot.footprint.empty() ? "footprint" : "radius")) continue;
    const Value value = parameter.get(robot);
    if (group.empty() || value != parameter.get(plain)) all[name] = value;
  }
  return all;
}

std::string canonical_text(const Robot& robot) {
  Settings all = settings_of(robot);
  all.erase("name");
  if (!(robot.min_turn_radius > 0)) all.erase("reverse");  // has no effect then
  return to_text(all);
}

Ring parse_footprint(const std::string& text) {
  if (text == "disc") return {};
  const std::size_t colon = text.find(':');
  const std::string shape = text.substr(0, colon);
  const auto width = parse_number(colon == std::string::npos ? "" : std::string_view(text).substr(colon + 1));
  if ((shape == "square" || shape == "octagon") && width && *width > 0) {
    const double h = *width / 2, t = h * (std::sqrt(2.0) - 1);
    if (shape == "square") return {{h, -h}, {h, h}, {-h, h}, {-h, -h}};
    return {{h, -t}, {h, t}, {t, h}, {-t, h}, {-h, t}, {-h, -t}, {-t, -h}, {t, -h}};
  }
  Ring ring = parse_vertices(text);
  if (!ring.empty()) return ring;
  throw_invalid(
      "footprint is '{}', expected disc, square:WIDTH or octagon:WIDTH in metres, or vertices such as "
      "\"0.5 0; 0 0.5; -0.5 0; 0 -0.5\"",
      text);
}

double in_radius(const Ring& footprint) {
  double least = std::numeric_limits<double>::infinity();
  for_each_edge(footprint,
                [&](const Point& a, const Point& b) { least = std::min(least, cross(a, b - a) / (b - a).norm()); });
  return least;
}

double height(const Robot& robot) {
  return robot.footprint.empty() ? 2 * robot.radius : bounding_box(robot.footprint).size().y();
}

void check(const Robot& robot) {
  const std::string owner = owner_of(robot);
  for (const Parameter<Robot>& parameter : robot_parameters())
    if (has_group(robot, robot_group(parameter.info.name)) && parameter.info.name != "footprint") {
      ParameterInfo info = parameter.info;
      info.fallback = parameter.get(Robot{});
      checked(owner, info, parameter.get(robot));
    }
  if (!robot.footprint.empty()) check_footprint(robot);
  if (!robot.tether) return;
  if (robot.tether->reach != 0 && robot.tether->length != 0)
    throw_invalid("{}: tether has a length and a reach, expected one of the two", owner);
  if (robot.tether->reach == 0 && robot.tether->length == 0)
    throw_invalid("{}: tether has no length, expected tether_length in metres or tether_reach", owner);
}

}  // namespace oxturn
