// The problems of the checks, by name.
#include <fmt/format.h>

#include <stdexcept>

#include "base/math.hpp"
#include "bench/check/subject.hpp"
#include "geometry/overlay/boolean.hpp"

namespace oxturn {
namespace {

struct Drawn {
  Region free;
  Robot robot = check_robot();
  std::optional<Point> start = {};
};

constexpr double kReach = 1.2;  // of tethers: times the distance of the farthest point

Drawn sized_room(double scale, double tool_over_radius = 2) {
  Robot robot = check_robot(scale);
  robot.tool_width = robot.radius * tool_over_radius;
  return {box_region({0, 0}, {5 * scale, 4 * scale}), robot};
}

Region with_pillar(Region region) {
  region.polygons.front().holes.push_back({{2, 1.5}, {2, 2.5}, {3, 2.5}, {3, 1.5}});
  return region;
}

/// A wavy disc: nothing in it is straight.
Region wavy(int vertices) {
  Ring ring;
  for (int k = 0; k < vertices; ++k) {
    const double angle = 2 * kPi * k / vertices, radius = 3 + 0.3 * math::sin(7 * angle) + 0.002 * (k % 2);
    ring.push_back({radius * math::cos(angle), radius * math::sin(angle)});
  }
  return {{{ring, {}}}};
}

/// A rectangle whose sides have many vertices, each of them twice, and every second pair a little off the line.
Region collinear() {
  constexpr double kOff = 4e-6, kApart = 1e-5;  // metres
  Ring ring;
  const auto side = [&](const Point& a, const Point& b) {
    const Point along = (b - a).normalized(), in = perpendicular(along);
    for (int k = 0; k < 200; ++k) {
      const Point p = lerp(a, b, k / 200.0) + (k % 2) * kOff * in;
      for (const Point& q : {p, p, Point(p + kApart * along)}) ring.push_back(q);
    }
  };
  side({0, 0}, {5, 0});
  side({5, 0}, {5, 4});
  side({5, 4}, {0, 4});
  side({0, 4}, {0, 0});
  return {{{ring, {}}}};
}

/// Dyadic numbers and nothing symmetric, so that turning, mirroring and scaling by 2 change no digit.
Drawn for_symmetries(bool pillar) {
  Drawn drawn{{{{{{0, 0}, {7, 0}, {7, 3.5}, {4.25, 3.5}, {4.25, 5}, {0, 5}}, {}}}}, {}, Point(0.5, 0.75)};
  if (pillar) drawn.free = with_pillar(drawn.free);
  drawn.robot.radius = 0.25;
  drawn.robot.tool_width = 0.5;
  return drawn;
}

Drawn drawn(const std::string& name) {
  if (name == "room") return {box_region({0, 0}, {5, 4})};
  if (name == "pillar") return {with_pillar(box_region({0, 0}, {5, 4}))};
  if (name == "no room to move") return {box_region({0, 0}, {0.402, 0.402})};
  if (name == "one cell") return {box_region({0, 0}, {0.45, 0.45})};
  if (name == "corridor as wide as the robot") return {box_region({0, 0}, {6, 0.402})};
  if (name == "disconnected") return {unite({box_region({0, 0}, {5, 4}), box_region({7, 0}, {9, 4})}), {}, Point(1, 1)};
  if (name == "ten thousand vertices") return {wavy(10000), check_robot(1.5)};
  if (name == "collinear and duplicate points") return {collinear()};
  if (name == "huge coordinates") return {transformed(box_region({0, 0}, {5, 4}), 0.3, {1e6, -1e6})};
  if (name == "tiny") return sized_room(1e-3);
  if (name == "huge") return sized_room(1e4);
  if (name == "start on the boundary") return {box_region({0, 0}, {5, 4}), check_robot(), Point(0.2, 1)};
  if (name == "wide tool") return sized_room(1, 5);
  if (name == "narrow tool") return sized_room(1, 0.5);
  if (name == "symmetries") return for_symmetries(false);
  if (name == "symmetries with a pillar") return for_symmetries(true);
  throw std::logic_error("no problem of the checks is called " + name);
}

}  // namespace

const Problem& CheckProblems::get(const std::string& name, bool tether) {
  const std::string key = (tether ? "tethered " : "") + name;
  if (const auto known = built_.find(key); known != built_.end()) return known->second;
  Map map{name, {}, "check", name};
  Robot robot = check_robot();
  std::optional<Point> start;
  if (const auto colon = name.find(':'); colon != std::string::npos) {  // a generator and its seed
    const std::string generator = name.substr(0, colon);
    const Settings size{{"width", 9.0}, {"height", 8.0}};
    map.free = generate(generator, size, std::stoull(name.substr(colon + 1)), generators_).free;
  } else {
    Drawn made = drawn(name);
    map.free = std::move(made.free);
    robot = made.robot;
    start = made.start;
  }
  if (tether) robot.tether = Tether{0, kReach};
  return built_.emplace(key, Problem(std::move(map), robot, start)).first->second;
}

}  // namespace oxturn
