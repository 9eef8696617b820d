// Time to drive the path: trapezoidal speed profile, stops at corners, slower in curves.
//
// Model       At a corner (a change above 0.3 rad that is no part of a sampled curve) the robot stops and turns on
//             the spot at turn_rate. Elsewhere it drives through, at most at turn_rate * local radius. A curve
//             tighter than min_turn_radius cannot be driven: the robot stops where it begins and where it ends and
//             goes along it at turn_rate * local radius, however finely it is sampled. It starts and ends at rest,
//             facing the right way. The tool takes no time to switch.
// Method      Speed limits per vertex and segment, a forward and a backward pass with the acceleration. O(n).
#include <algorithm>
#include <cmath>

#include "metrics/heading.hpp"

namespace oxturn {

extern const Metric kMissionS;

namespace {

/// Radius of the curve at a vertex between straight pieces of these lengths. Where a curve meets a straight line,
/// the vertex has half a chord's change.
double local_radius(double before, double after, double angle) {
  const double least = std::min(before, after), most = std::max(before, after);
  return most > 2 * least ? least / (2 * angle) : (before + after) / (2 * angle);
}

/// Time over `length` from speed u to speed v (both reachable), never above `top`.
double drive_time(double length, double u, double v, double top, double acceleration) {
  const double peak2 = (u * u + v * v) / 2 + acceleration * length;
  if (peak2 <= top * top) return (2 * std::sqrt(peak2) - u - v) / acceleration;
  const double ramps = (2 * top * top - u * u - v * v) / (2 * acceleration);
  return (2 * top - u - v) / acceleration + std::max(0.0, length - ramps) / top;
}

double mission(const Problem& problem, const Path& path) {
  const Robot& robot = problem.robot();
  const Headings h = headings(problem, path);
  const std::size_t n = h.turns.size();
  const auto length_after = [&](std::size_t i) { return i + 1 < n ? h.turns[i + 1].before : h.after; };
  if (n == 0) return h.after > 0 ? drive_time(h.after, 0, 0, robot.speed, robot.acceleration) : 0;

  // Segment i ends at turn i; segment n ends the path. Speeds at both ends: v[i], v[i + 1].
  std::vector<double> through(n), v(n + 2, 0), top(n + 1, robot.speed);
  std::vector<bool> tight(n, false);
  double turning = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Turn& turn = h.turns[i];
    const bool curve = turn.linked || (i + 1 < n && h.turns[i + 1].linked);
    const double angle = std::abs(turn.angle);
    const double radius = local_radius(turn.before, length_after(i), angle);
    through[i] = std::min(robot.speed, robot.turn_rate * radius);
    tight[i] = radius < robot.min_turn_radius;
    if (!curve && (angle > kCorner || tight[i])) {
      through[i] = 0;
      tight[i] = false;
      turning += angle / robot.turn_rate;
    }
  }
  for (std::size_t i = 0; i + 1 < n; ++i)
    if (h.turns[i + 1].linked) top[i + 1] = std::max(through[i], through[i + 1]);
  for (std::size_t i = 0; i < n; ++i) {
    const bool begins = tight[i] && !(i > 0 && tight[i - 1] && h.turns[i].linked);
    const bool ends = tight[i] && !(i + 1 < n && tight[i + 1] && h.turns[i + 1].linked);
    v[i + 1] = begins || ends ? 0 : through[i];
  }
  const auto length = [&](std::size_t i) { return i < n ? h.turns[i].before : h.after; };
  const double twice = 2 * robot.acceleration;
  for (std::size_t i = 0; i <= n; ++i) v[i + 1] = std::min(v[i + 1], std::sqrt(v[i] * v[i] + twice * length(i)));
  for (std::size_t i = n + 1; i-- > 0;) v[i] = std::min(v[i], std::sqrt(v[i + 1] * v[i + 1] + twice * length(i)));
  double time = turning;
  for (std::size_t i = 0; i <= n; ++i)
    time += drive_time(length(i), v[i], v[i + 1], std::max({top[i], v[i], v[i + 1]}), robot.acceleration);
  return time;
}

}  // namespace

const Metric kMissionS{"mission_s", "s", Better::lower, "time to drive the path, stopping at corners",
                       [](const Scored& s) -> std::optional<double> { return mission(s.problem, s.path); }};

}  // namespace oxturn
