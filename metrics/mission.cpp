#include "metrics/mission.hpp"

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

/// Time over the first `part` of what drive_time is about.
double part_time(double part, double length, double u, double v, double top, double acceleration) {
  if (part >= length) return drive_time(length, u, v, top, acceleration);
  const double peak = std::min(top, std::sqrt((u * u + v * v) / 2 + acceleration * length));
  const double up = (peak * peak - u * u) / (2 * acceleration), down = (peak * peak - v * v) / (2 * acceleration);
  if (part <= up) return (std::sqrt(u * u + 2 * acceleration * part) - u) / acceleration;
  const double rest = length - part;
  if (rest >= down) return (peak - u) / acceleration + (part - up) / peak;
  const double all = drive_time(length, u, v, top, acceleration);
  return all - (std::sqrt(v * v + 2 * acceleration * rest) - v) / acceleration;
}

}  // namespace

MissionClock::MissionClock(const Problem& problem, const Path& path) : acceleration_(problem.robot().acceleration) {
  const Robot& robot = problem.robot();
  const Headings h = headings(problem, path);
  const std::size_t n = h.turns.size();
  const auto length_after = [&](std::size_t i) { return i + 1 < n ? h.turns[i + 1].before : h.after; };
  if (n == 0 && !(h.after > 0)) return;

  // Segment i ends at turn i; segment n ends the path. Speeds at both ends: v[i], v[i + 1].
  std::vector<double> through(n), v(n + 2, 0), top(n + 1, robot.speed), turning(n, 0);
  std::vector<bool> tight(n, false);
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
      turning[i] = angle / robot.turn_rate;
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
  double driven = 0;
  for (std::size_t i = 0; i <= n; ++i) {
    const double most = std::max({top[i], v[i], v[i + 1]});
    stretches_.push_back({driven, total_, length(i), v[i], v[i + 1], most});
    driven += length(i);
    total_ += drive_time(length(i), v[i], v[i + 1], most, acceleration_) + (i < n ? turning[i] : 0);
  }
}

double MissionClock::at(double path_m) const {
  if (stretches_.empty() || path_m <= 0) return 0;
  const auto after = std::lower_bound(stretches_.begin(), stretches_.end(), path_m,
                                      [](const Stretch& s, double m) { return s.begin_m < m; });
  const Stretch& s = *std::prev(after);  // the first begins at 0, so one is before
  return s.begin_s + part_time(path_m - s.begin_m, s.length, s.from_speed, s.to_speed, s.top, acceleration_);
}

const Metric kMissionS{
    "mission_s", "s", Better::lower, "time to drive the path, stopping at corners",
    [](const Scored& s) -> std::optional<double> { return MissionClock(s.problem, s.path).total(); }};

}  // namespace oxturn
