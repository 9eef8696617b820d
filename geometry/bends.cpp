#include "geometry/bends.hpp"

#include <algorithm>
#include <cmath>

#include "base/math.hpp"

namespace oxturn {
namespace {

constexpr double kStraight = 1e-7;    // radians; less is rounding
constexpr double kChordError = 1e-3;  // tool widths
constexpr double kAllowed = 1.01;

/// An edge without the points in its middle.
struct Edge {
  Point heading{0, 0};  // as long as the first of its parts
  double length = 0;
  Point end{0, 0};
};

std::vector<Edge> straight_edges(const Path& path, double tolerance) {
  std::vector<Edge> edges;
  const Point* at = nullptr;
  for (const Leg& leg : path.legs)
    for (const Point& p : leg.points) {
      if (at == nullptr) at = &p;
      const Point step = leg.gear == Gear::forward ? Point(p - *at) : Point(*at - p);
      if (step.norm() <= tolerance) continue;
      at = &p;
      const Point before = edges.empty() ? step : edges.back().heading;
      if (edges.empty() || std::abs(math::atan2(cross(before, step), before.dot(step))) > kStraight)
        edges.push_back({step, 0, p});
      edges.back().length += step.norm();
      edges.back().end = p;
    }
  return edges;
}

}  // namespace

std::vector<Bend> bends(const Path& path, double tolerance, double tool_width) {
  const std::vector<Edge> edges = straight_edges(path, tolerance);
  std::vector<Bend> result;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const Point &u = edges[i - 1].heading, &v = edges[i].heading;
    const double a = edges[i - 1].length, b = edges[i].length;
    const double d = std::abs(math::atan2(cross(u, v), u.dot(v)));
    const double chord = std::sqrt(std::max(0.0, a * a + b * b + 2 * a * b * math::cos(d)));
    const double circle = chord > 0 ? 2 * math::sin(d) / chord : 0;
    const double corner = (1 - math::cos(d / 2)) / (kChordError * tool_width);
    result.push_back({edges[i - 1].end, std::max(circle, corner), 4 * tolerance / (a * b)});
  }
  return result;
}

bool too_sharp(const Bend& bend, double least_radius) { return bend.curvature > kAllowed / least_radius + bend.error; }

}  // namespace oxturn
