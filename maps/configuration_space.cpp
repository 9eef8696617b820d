#include "maps/configuration_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.hpp"
#include "base/throw_invalid.hpp"
#include "geometry/edge_index.hpp"
#include "geometry/mesh/mesh.hpp"
#include "geometry/overlay/boolean.hpp"
#include "geometry/overlay/minkowski.hpp"
#include "geometry/overlay/offset.hpp"
#include "geometry/predicates.hpp"

namespace oxturn {
namespace {

constexpr std::size_t kWorthIndex = 32;  // an index costs as much as some dozen scans

/// Distance of p from a closed polygon. By a scan: a single query does not pay for an EdgeIndex.
double distance_to(const Polygon& polygon, const Point& p) {
  const Region region{{polygon}};
  double least = std::numeric_limits<double>::infinity();
  for_each_edge(region, [&](const Point& a, const Point& b) {
    least = on_segment(p, a, b) ? 0 : std::min(least, distance_to_segment(p, a, b));
  });
  return contains(region, p) ? 0 : least;
}

/// In the largest component, at the roomiest point of `around` that lies in it, or at its own.
Point roomy_start(const Region& all, const Region& around) {
  const Region component{{*std::ranges::max_element(all.polygons, {}, [](const Polygon& p) { return area(p); })}};
  std::size_t asked = 0;
  std::optional<EdgeIndex> edges;
  const auto fits = [&](const Point& p) {
    if (++asked == kWorthIndex) edges.emplace(component);
    return edges ? edges->contains(p) : contains(component, p);
  };
  if (const auto start = Mesh(around).roomiest_point(fits)) return *start;
  // A component thinner than any triangle is all boundary.
  return Mesh(component).roomiest_point().value_or(component.polygons[0].outer.front());
}

}  // namespace

std::string size_text(const Robot& robot) {
  if (robot.footprint.empty()) return "radius " + to_decimal(robot.radius);
  return fmt::format("footprint of {} vertices", robot.footprint.size());
}

Region eroded(const Map& map, const Region& free, const Robot& robot) {
  Region all = !robot.footprint.empty() ? erode(free, robot.footprint, Bound::inside)
               : robot.radius > 0       ? erode(free, robot.radius, robot.tool_width / 1000, Bound::inside)
                                        : free;
  if (all.empty()) {
    const Point size = bounding_box(free).size();
    throw_invalid(
        "robot '{}' ({}) fits nowhere in map '{}', whose free space is {:.4g} x {:.4g} m; take a smaller robot, "
        "or check the map's scale",
        robot.name, size_text(robot), map.name, size.x(), size.y());
  }
  return all;
}

const Polygon* component_at(const Region& all, const Point& p, double tolerance) {
  const Polygon* nearest = nullptr;
  double least = tolerance;
  for (const Polygon& polygon : all.polygons) {
    Box box = bounding_box(polygon.outer);
    box.grow(tolerance);
    if (!box.contains(p)) continue;
    const double away = distance_to(polygon, p);
    if (away == 0) return &polygon;
    if (away <= least) {
      least = away;
      nearest = &polygon;
    }
  }
  return nearest;
}

bool holds(const Region& region, const Point& p, double tolerance) {
  return component_at(region, p, tolerance) != nullptr;
}

Point nearest_point_inside(const Region& all, const Point& p, double tool_width) {
  const EdgeIndex edges(all);
  const auto hit = edges.nearest(p);
  const Point nearest = hit ? hit->point : all.polygons.front().outer.front();
  for (const double unit : {1e2, 1e3, 1e4, 1e5, 1e6}) {
    std::optional<Point> best;
    for (const int i : {0, -1, 1})
      for (const int j : {0, -1, 1}) {
        const Point q((std::round(nearest.x() * unit) + i) / unit, (std::round(nearest.y() * unit) + j) / unit);
        if (distance(q, nearest) > tool_width / 5 || !edges.contains(q)) continue;
        if (!best || distance(q, p) < distance(*best, p)) best = q;
      }
    if (best) return *best;
  }
  return nearest;
}

Point find_default_start(const Region& all, const Region& free, const Region* target_area, double tool_width) {
  if (target_area != nullptr) {
    Region near = intersect(all, *target_area);
    if (near.empty()) near = intersect(all, dilate(*target_area, tool_width / 2, tool_width / 1000, Bound::inside));
    if (!near.empty()) return roomy_start(near, *target_area);
  }
  return roomy_start(all, free);
}

}  // namespace oxturn
