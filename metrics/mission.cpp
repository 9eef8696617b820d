#include "metrics/mission.hpp"

#include <algorithm>
#include <cmath>

#include "metrics/heading.hpp"

namespace oxturn {
namespace {

/// Radius of the curve at a vertex between straight pieces of these lengths. Where a curve continues in its tangent,
/// the vertex has half a chord's change of heading.
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

/// Time over the first `part` metres of the same drive.
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

/// Length of straight i, which ends at turn i; the last straight ends the path.
double straight_length(const Headings& h, std::size_t i) { return i < h.turns.size() ? h.turns[i].before : h.after; }

bool is_linked(const Headings& h, std::size_t i) { return i < h.turns.size() && h.turns[i].linked; }

/// How a turn limits the robot.
struct TurnLimit {
  double through = 0;  // speed
  double turning = 0;  // seconds on the spot
  bool tight = false;  // part of a curve that the robot cannot drive
};

TurnLimit limit_of(const Headings& h, std::size_t i, const Robot& robot) {
  const Turn& turn = h.turns[i];
  const double angle = std::abs(turn.angle);
  const double radius = local_radius(turn.before, straight_length(h, i + 1), angle);
  const bool tight = radius < robot.min_turn_radius, curve = turn.linked || is_linked(h, i + 1);
  if (!curve && (angle > kCorner || tight)) return {0, angle / robot.turn_rate, false};
  return {std::min(robot.speed, robot.turn_rate * radius), 0, tight};
}

/// Speeds at both ends of straight i: ends[i] and ends[i + 1]. By the limits of the turns, stops at the ends of tight
/// curves, and the acceleration in both directions.
std::vector<double> end_speeds(const Headings& h, const std::vector<TurnLimit>& limits, double acceleration) {
  const std::size_t n = limits.size();
  std::vector<double> ends(n + 2, 0);
  for (std::size_t i = 0; i < n; ++i) {
    const bool begins = limits[i].tight && !(i > 0 && limits[i - 1].tight && is_linked(h, i));
    const bool stops = limits[i].tight && !(i + 1 < n && limits[i + 1].tight && is_linked(h, i + 1));
    ends[i + 1] = begins || stops ? 0 : limits[i].through;
  }
  const double twice = 2 * acceleration;
  for (std::size_t i = 0; i <= n; ++i)
    ends[i + 1] = std::min(ends[i + 1], std::sqrt(ends[i] * ends[i] + twice * straight_length(h, i)));
  for (std::size_t i = n + 1; i-- > 0;)
    ends[i] = std::min(ends[i], std::sqrt(ends[i + 1] * ends[i + 1] + twice * straight_length(h, i)));
  return ends;
}

}  // namespace

MissionClock::MissionClock(const Problem& problem, const Path& path) : acceleration_(problem.robot().acceleration) {
  const Robot& robot = problem.robot();
  const Headings h = headings(problem, path);
  const std::size_t n = h.turns.size();
  if (n == 0 && !(h.after > 0)) return;
  std::vector<TurnLimit> limits;
  for (std::size_t i = 0; i < n; ++i) limits.push_back(limit_of(h, i, robot));
  const std::vector<double> ends = end_speeds(h, limits, robot.acceleration);
  double driven = 0;
  for (std::size_t i = 0; i <= n; ++i) {
    const double length = straight_length(h, i);
    const bool in_curve = i > 0 && is_linked(h, i);  // a chord of a curve
    const double limit = in_curve ? std::max(limits[i - 1].through, limits[i].through) : robot.speed;
    const double top = std::max({limit, ends[i], ends[i + 1]});
    straights_.push_back({driven, total_, length, ends[i], ends[i + 1], top});
    driven += length;
    total_ += drive_time(length, ends[i], ends[i + 1], top, acceleration_) + (i < n ? limits[i].turning : 0);
  }
}

double MissionClock::at(double path_m) const {
  if (straights_.empty() || path_m <= 0) return 0;
  const auto after = std::lower_bound(straights_.begin(), straights_.end(), path_m,
                                      [](const Straight& s, double m) { return s.begin_m < m; });
  const Straight& s = *std::prev(after);  // the first begins at 0, so there is one before
  return s.begin_s + part_time(path_m - s.begin_m, s.length, s.from_speed, s.to_speed, s.top, acceleration_);
}

}  // namespace oxturn
