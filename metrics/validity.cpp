// Can the robot drive this path? The first rule that it breaks, where, and by how much.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/bends.hpp"
#include "geometry/point_outside.hpp"
#include "metrics/footprint.hpp"
#include "metrics/score.hpp"
#include "metrics/walls.hpp"

namespace oxturn {
namespace {

std::string text(const Point& p) { return fmt::format("({:.6g}, {:.6g})", p.x(), p.y()); }

/// Rules about legs, points and joints.
std::string find_shape_flaw(const Problem& problem, const Path& path, double tolerance) {
  if (path.legs.empty()) return "path has no legs";
  for (std::size_t l = 0; l < path.legs.size(); ++l) {
    const Polyline& points = path.legs[l].points;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!finite(points[i])) return fmt::format("leg {} point {} is not finite", l + 1, i + 1);
  }
  for (std::size_t l = 0; l < path.legs.size(); ++l) {
    const Polyline& points = path.legs[l].points;
    if (points.size() < 2)
      return fmt::format("leg {} has {} point{}, expected at least 2", l + 1, points.size(),
                         points.size() == 1 ? "" : "s");
    if (l == 0 && distance(points.front(), problem.start()) > tolerance)
      return fmt::format("starts at {}, the problem's start is {}", text(points.front()), text(problem.start()));
    if (l == 0) continue;
    const double gap = distance(path.legs[l - 1].points.back(), points.front());
    if (gap > tolerance)
      return fmt::format("leg {} starts at {}, {:.3g} m from where leg {} ended", l + 1, text(points.front()), gap, l);
  }
  return "";
}

std::string find_footprint_flaw(const Problem& problem, const Path& path, const EdgeIndex& walls, double tolerance) {
  const auto hit = first_hit(path, problem.robot().footprint, tolerance, walls);
  if (!hit) return "";
  return fmt::format("leaves configuration space at {}: the footprint reaches {:.3g} m into a wall", text(hit->at),
                     hit->depth);
}

/// Of a segment, for a disc of this radius.
std::string find_disc_flaw(const Point& a, const Point& b, double radius, double tolerance, const EdgeIndex& walls) {
  if (radius > tolerance) {
    const auto hit = walls.nearest(a, b, radius - tolerance);
    if (!hit || hit->distance >= radius - tolerance) return "";
    return fmt::format("leaves configuration space at {}: {}, robot radius {:.6g} m", text(hit->from),
                       hit->distance > 0 ? fmt::format("{:.6g} m from a wall", hit->distance) : "in a wall", radius);
  }
  const auto outside = point_outside(walls, a, b, tolerance);
  if (!outside) return "";
  const auto wall = walls.nearest(*outside);
  return fmt::format("leaves configuration space at {}: {:.3g} m inside a wall", text(*outside),
                     wall ? wall->distance : 0.0);
}

/// Of a robot that cannot turn on the spot.
std::string find_turn_flaw(const Problem& problem, const Path& path, double tolerance) {
  const Robot& robot = problem.robot();
  if (!(robot.min_turn_radius > 0)) return "";
  for (const Leg& leg : path.legs)
    if (leg.gear == Gear::reverse && !robot.reverse)
      return fmt::format("drives backwards at {}, robot '{}' only forwards (reverse = false)", text(leg.points.front()),
                         robot.name);
  for (const Bend& bend : bends(path, tolerance, robot.tool_width))
    if (too_sharp(bend, robot.min_turn_radius))
      return fmt::format("turns too sharply at {}: radius {:.3g} m, min_turn_radius {:.6g} m", text(bend.at),
                         1 / bend.curvature, robot.min_turn_radius);
  return "";
}

std::string find_disc_flaw(const Problem& problem, const Path& path, const EdgeIndex& walls, double tolerance) {
  for (const Leg& leg : path.legs)
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      std::string flaw = find_disc_flaw(leg.points[i - 1], leg.points[i], problem.robot().radius, tolerance, walls);
      if (!flaw.empty()) return flaw;
    }
  return "";
}

}  // namespace

std::string find_flaw(const Problem& problem, const Path& path, const EdgeIndex& walls, double tolerance) {
  if (std::string flaw = find_shape_flaw(problem, path, tolerance); !flaw.empty()) return flaw;
  const Point& start = path.legs.front().points.front();
  if (!nearly_contains(walls, start, tolerance)) return fmt::format("starts at {}, inside a wall", text(start));
  if (!problem.robot().footprint.empty()) return find_footprint_flaw(problem, path, walls, tolerance);
  std::string flaw = find_disc_flaw(problem, path, walls, tolerance);
  return flaw.empty() ? find_turn_flaw(problem, path, tolerance) : flaw;
}

double clearance(const Problem& problem, const Path& path, const EdgeIndex& walls) {
  if (!problem.robot().footprint.empty()) return footprint_clearance(path, problem.robot().footprint, walls);
  double least = std::numeric_limits<double>::infinity();
  bool may_be_outside = false;
  const Point* last = nullptr;
  for (const Leg& leg : path.legs) {
    if (leg.points.empty()) continue;
    // The first point, and a point after a jump, is not the end of a tested segment.
    if (last == nullptr || *last != leg.points.front())
      may_be_outside = may_be_outside || !walls.contains(leg.points.front());
    for (std::size_t i = 0; i < leg.points.size(); ++i) {
      const auto hit = walls.nearest(leg.points[i == 0 ? 0 : i - 1], leg.points[i], least);
      if (hit) least = std::min(least, hit->distance);
    }
    last = &leg.points.back();
  }
  if (may_be_outside || least <= 0)
    for (const Leg& leg : path.legs)
      for (const Point& p : leg.points)
        if (!walls.contains(p))
          if (const auto hit = walls.nearest(p)) least = std::min(least, -hit->distance);
  return least - problem.robot().radius;
}

}  // namespace oxturn
