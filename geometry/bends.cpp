#include "geometry/bends.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

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
  double turn = 0;  // from the edge before, radians
};

/// Calls f(edge) for the edges in driving order.
template <class F>
void for_each_straight_edge(const Path& path, double tolerance, F f) {
  std::optional<Edge> edge;
  const Point* at = nullptr;
  for (const Leg& leg : path.legs)
    for (const Point& p : leg.points) {
      if (at == nullptr) at = &p;
      const Point step = leg.gear == Gear::forward ? Point(p - *at) : Point(*at - p);
      const double length = step.norm();
      if (length <= tolerance) continue;
      at = &p;
      const double turn = edge ? std::abs(math::atan2(cross(edge->heading, step), edge->heading.dot(step))) : 0;
      if (edge && turn > kStraight) {
        f(*edge);
        edge.reset();
      }
      if (!edge) edge = Edge{step, 0, p, turn};
      edge->length += length;
      edge->end = p;
    }
  if (edge) f(*edge);
}

}  // namespace

void for_each_bend(const Path& path, double tolerance, double tool_width, const std::function<void(const Bend&)>& f) {
  std::optional<Edge> before;
  for_each_straight_edge(path, tolerance, [&](const Edge& edge) {
    if (before) {
      const double a = before->length, b = edge.length, d = edge.turn;
      const double chord = std::sqrt(std::max(0.0, a * a + b * b + 2 * a * b * math::cos(d)));
      const double circle = chord > 0 ? 2 * math::sin(d) / chord : 0;
      const double corner = (1 - math::cos(d / 2)) / (kChordError * tool_width);
      f({before->end, std::max(circle, corner), 4 * tolerance / (a * b)});
    }
    before = edge;
  });
}

std::vector<Bend> bends(const Path& path, double tolerance, double tool_width) {
  std::vector<Bend> all;
  for_each_bend(path, tolerance, tool_width, [&](const Bend& bend) { all.push_back(bend); });
  return all;
}

bool too_sharp(const Bend& bend, double least_radius) { return bend.curvature > kAllowed / least_radius + bend.error; }

}  // namespace oxturn
