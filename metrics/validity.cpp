// Is this path one that the robot can drive? The first rule that it breaks, where, by how much.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/point_outside.hpp"
#include "metrics/footprint.hpp"
#include "metrics/score.hpp"
#include "metrics/walls.hpp"

namespace oxturn {
namespace {

std::string text(const Point& p) { return fmt::format("({:.6g}, {:.6g})", p.x(), p.y()); }

/// Legs, points, joints: everything but the walls.
std::string find_shape_flaw(const Problem& problem, const Path& path) {
  if (path.legs.empty()) return "path has no legs";
  const double tolerance = problem.tolerance();
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

}  // namespace

std::string find_flaw(const Problem& problem, const Path& path, const EdgeIndex& walls) {
  if (std::string flaw = find_shape_flaw(problem, path); !flaw.empty()) return flaw;
  const double tolerance = problem.tolerance(), radius = problem.robot().radius;
  const Point& start = path.legs.front().points.front();
  if (!nearly_contains(walls, start, tolerance)) return fmt::format("starts at {}, inside a wall", text(start));
  if (const Ring& footprint = problem.robot().footprint; !footprint.empty()) {
    const auto hit = first_hit(path, footprint, tolerance, walls);
    return hit ? fmt::format("leaves configuration space at {}: the footprint reaches {:.3g} m into a wall",
                             text(hit->at), hit->depth)
               : "";
  }
  for (const Leg& leg : path.legs) {
    for (std::size_t i = 1; i < leg.points.size(); ++i) {
      const Point &a = leg.points[i - 1], &b = leg.points[i];
      if (radius > tolerance) {
        const auto hit = walls.nearest(a, b, radius - tolerance);
        if (!hit || hit->distance >= radius - tolerance) continue;
        return fmt::format("leaves configuration space at {}: {}, robot radius {:.6g} m", text(hit->from),
                           hit->distance > 0 ? fmt::format("{:.6g} m from a wall", hit->distance) : "in a wall",
                           radius);
      }
      if (const auto out = point_outside(walls, a, b, tolerance)) {
        const auto depth = walls.nearest(*out);
        return fmt::format("leaves configuration space at {}: {:.3g} m inside a wall", text(*out),
                           depth ? depth->distance : 0.0);
      }
    }
  }
  return "";
}

double clearance(const Problem& problem, const Path& path, const EdgeIndex& walls) {
  if (!problem.robot().footprint.empty()) return footprint_clearance(path, problem.robot().footprint, walls);
  double least = std::numeric_limits<double>::infinity();
  bool suspect = false;  // somewhere it may be outside
  const Point* last = nullptr;
  for (const Leg& leg : path.legs) {
    if (leg.points.empty()) continue;
    // A jump, or the very first point: no segment led here, so ask directly.
    if (last == nullptr || *last != leg.points.front()) suspect = suspect || !walls.contains(leg.points.front());
    for (std::size_t i = 0; i < leg.points.size(); ++i) {
      const auto hit = walls.nearest(leg.points[i == 0 ? 0 : i - 1], leg.points[i], least);
      if (hit) least = std::min(least, hit->distance);
    }
    last = &leg.points.back();
  }
  suspect = suspect || least <= 0;
  if (suspect)
    for (const Leg& leg : path.legs)
      for (const Point& p : leg.points)
        if (!walls.contains(p))
          if (const auto hit = walls.nearest(p)) least = std::min(least, -hit->distance);
  return least - problem.robot().radius;
}

}  // namespace oxturn
