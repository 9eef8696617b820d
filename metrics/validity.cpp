// Is this path one that the robot can drive? The first rule that it breaks, where, by how much.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

bool inside(const EdgeIndex& walls, const Point& p, double tolerance) {
  return walls.contains(p) || walls.nearest(p, tolerance).has_value();
}

/// For robots without size, whose path may run along a wall and by rounding a hair beyond it: a place of ab that
/// is more than `tolerance` outside. The segment is cut where it may meet a wall; each part is judged in its middle.
std::optional<Point> place_outside(const EdgeIndex& walls, const Point& a, const Point& b, double tolerance) {
  if (walls.contains(a, b)) return std::nullopt;
  const Point d = b - a;
  std::vector<double> cuts{0, 1};
  Box box;
  box.add(a);
  box.add(b);
  walls.for_each_near(box, [&](std::size_t e) {
    const EdgeIndex::Edge& edge = walls.edges()[e];
    const Point side = edge.b - edge.a;
    const double turn = cross(d, side);
    if (turn != 0) cuts.push_back(cross(edge.a - a, side) / turn);
    if (d.squaredNorm() > 0)
      for (const Point& p : {edge.a, edge.b}) cuts.push_back((p - a).dot(d) / d.squaredNorm());
  });
  std::erase_if(cuts, [](double t) { return !(t >= 0 && t <= 1); });
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const Point end = lerp(a, b, cuts[i]);
    if (!inside(walls, end, tolerance)) return end;
    if (i == 0) continue;
    const Point middle = lerp(a, b, (cuts[i - 1] + cuts[i]) / 2);
    if (!inside(walls, middle, tolerance)) return middle;
  }
  return std::nullopt;
}

}  // namespace

std::string find_flaw(const Problem& problem, const Path& path, const EdgeIndex& walls) {
  if (std::string flaw = find_shape_flaw(problem, path); !flaw.empty()) return flaw;
  const double tolerance = problem.tolerance(), radius = problem.robot().radius;
  const Point& start = path.legs.front().points.front();
  if (!inside(walls, start, tolerance)) return fmt::format("starts at {}, inside a wall", text(start));
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
      if (const auto out = place_outside(walls, a, b, tolerance)) {
        const auto depth = walls.nearest(*out);
        return fmt::format("leaves configuration space at {}: {:.3g} m inside a wall", text(*out),
                           depth ? depth->distance : 0.0);
      }
    }
  }
  return "";
}

std::string find_flaw(const Problem& problem, const Path& path) {
  return find_flaw(problem, path, EdgeIndex(problem.map().free));
}

double clearance(const Problem& problem, const Path& path, const EdgeIndex& walls) {
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
