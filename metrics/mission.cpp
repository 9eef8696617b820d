#include "metrics/mission.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "base/math.hpp"
#include "metrics/smooth_path.hpp"

namespace oxturn {
namespace {

constexpr double kHalfWidth = 0.1;    // of the smoothing, in tool widths
constexpr double kStep = 1;           // half-widths between samples near bends, at most
constexpr double kMostTurn = 0.15;    // radians between samples, unless they are nearer than the next
constexpr double kLeastStep = 1e-3;   // half-widths
constexpr double kNoHeading = 1e-6;   // the curve's derivative by arc length; below, it turns back on itself
constexpr double kRounding = 1e-9;    // of the same derivative
constexpr double kWholeSteps = 1e-6;  // rounding of a number of steps

/// Seconds over `length` from speed u to speed v (both reachable), never above `top`.
double seconds(double length, double u, double v, double top, double acceleration) {
  const double peak2 = (u * u + v * v) / 2 + acceleration * length;
  if (peak2 <= top * top) return (2 * std::sqrt(peak2) - u - v) / acceleration;
  const double ramps = (2 * top * top - u * u - v * v) / (2 * acceleration);
  return (2 * top - u - v) / acceleration + std::max(0.0, length - ramps) / top;
}

/// Seconds over the first `part` metres of the same drive.
double seconds_of_part(double part, double length, double u, double v, double top, double acceleration) {
  const double peak = std::min(top, std::sqrt((u * u + v * v) / 2 + acceleration * length));
  const double up = (peak * peak - u * u) / (2 * acceleration), down = (peak * peak - v * v) / (2 * acceleration);
  if (part <= up) return (std::sqrt(u * u + 2 * acceleration * part) - u) / acceleration;
  const double rest = std::max(0.0, length - part);
  if (rest >= down) return (peak - u) / acceleration + (part - up) / peak;
  const double all = seconds(length, u, v, top, acceleration);
  return all - (std::sqrt(v * v + 2 * acceleration * rest) - v) / acceleration;
}

/// 0 if `a` is no heading.
double turn_between(const Point& a, const Point& b) {
  if (a == Point(0, 0)) return 0;
  return std::abs(math::atan2(cross(a, b), a.dot(b)));
}

/// Consecutive legs, all driven forwards or all backwards.
using Part = std::span<const Leg>;

std::vector<Part> parts_of_one_gear(const Path& path) {
  std::vector<Part> parts;
  for (std::size_t first = 0, end = 0; first < path.legs.size(); first = end) {
    while (end < path.legs.size() && path.legs[end].gear == path.legs[first].gear) ++end;
    parts.push_back(Part(path.legs).subspan(first, end - first));
  }
  return parts;
}

/// The heading on the segment from a to b.
Point heading_on(const Point& a, const Point& b, Gear gear) { return gear == Gear::forward ? b - a : a - b; }

/// Of a part with a length.
Point first_heading(Part part) {
  for (const Leg& leg : part)
    for (std::size_t i = 1; i < leg.points.size(); ++i)
      if (leg.points[i] != leg.points[i - 1]) return heading_on(leg.points[i - 1], leg.points[i], leg.gear);
  return {0, 0};
}
Point last_heading(Part part) {
  for (auto leg = part.rbegin(); leg != part.rend(); ++leg)
    for (std::size_t i = leg->points.size(); i-- > 1;)
      if (leg->points[i] != leg->points[i - 1]) return heading_on(leg->points[i - 1], leg->points[i], leg->gear);
  return {0, 0};
}

}  // namespace

/// Samples the smooth path, left to right.
class MissionClock::Sampler {
 public:
  /// `before`: metres driven before this part of the path.
  Sampler(SmoothPath& path, const Robot& robot, double before, std::deque<Interval>& out)
      : path_(path), robot_(robot), before_(before), first_(out.size()), out_(out) {}

  void run() {
    const double reach = 2 * path_.half_width();
    const std::vector<double>& bends = path_.bends();
    last_ = sample(-reach);
    double from = -reach, to = -reach;  // of consecutive bends whose windows overlap
    for (const double bend : bends) {
      if (bend - reach > to) {
        add_window(from, to);
        advance(sample(bend - reach));
        from = bend - reach;
      }
      to = bend + reach;
    }
    add_window(from, to);
    out_.push_back({before_ + last_.state.progress, 0, 0, last_.limit, 0, 0});
    cap_tight_turns();
  }

 private:
  struct Sample {
    double s;
    SmoothPath::State state;
    double stretch;  // metres of the curve per metre of the path
    double limit;    // of the speed
    bool heads;      // has a heading
  };

  Sample sample(double s) {
    const SmoothPath::State state = path_.at(s);
    const double rate = state.first.norm();
    const bool drives = state.rate > kRounding;  // not at the path's very ends
    Sample result{s, state, 1, robot_.speed, drives && rate > kNoHeading * state.rate};
    if (drives) result.stretch = std::min(1.0, rate / state.rate);
    const double turning = std::abs(cross(state.first, state.second));
    if (result.heads && turning > 0)
      result.limit = std::min(robot_.speed, robot_.turn_rate * rate * rate * rate / turning);
    if (!result.heads && drives) result.limit = kNoHeading * robot_.speed;
    return result;
  }

  /// Of the speed at this radius of curvature. Below the least radius the robot turns partly at rest, so it drives
  /// faster in between; at a cusp it stops.
  double limit(double radius) const {
    const double least = robot_.min_turn_radius;
    return std::min(robot_.speed, robot_.turn_rate * (radius >= least ? radius : std::sqrt(least * radius)));
  }

  void add_window(double from, double to) {
    const double steps = std::ceil((to - from) / (kStep * path_.half_width()) - kWholeSteps);
    for (std::int64_t k = 1; k <= static_cast<std::int64_t>(steps); ++k)
      refine(sample(from + (to - from) * (static_cast<double>(k) / steps)));
  }

  /// Advances to `next`, in smaller steps where the curve turns a lot.
  void refine(const Sample& next) {
    const Point& heading = last_.heads ? last_.state.first : heading_;
    if (next.heads && turn_between(heading, next.state.first) > kMostTurn &&
        next.s - last_.s > kLeastStep * path_.half_width()) {
      refine(sample((last_.s + next.s) / 2));
      refine(next);
      return;
    }
    advance(next);
  }

  void advance(const Sample& next) {
    if (last_.heads) heading_ = last_.state.first;
    Interval interval{before_ + last_.state.progress, 0, 0, last_.limit, 0, 0};
    interval.length = (next.state.progress - last_.state.progress) * (last_.stretch + next.stretch) / 2;
    if (next.heads) interval.turn = turn_between(heading_, next.state.first);
    out_.push_back(interval);
    last_ = next;
  }

  /// Where the heading changes too fast to be sampled, the robot turns on the spot.
  void cap_tight_turns() {
    for (std::size_t i = first_; i + 1 < out_.size(); ++i) {
      if (out_[i].turn <= 2 * kMostTurn) continue;
      const double most = limit(out_[i].length / out_[i].turn);
      out_[i].speed = std::min(out_[i].speed, most);
      out_[i + 1].speed = std::min(out_[i + 1].speed, most);
    }
  }

  SmoothPath& path_;
  const Robot& robot_;
  double before_;
  std::size_t first_;  // of this part's intervals
  std::deque<Interval>& out_;
  Sample last_{};
  Point heading_{0, 0};  // the last one
};

MissionClock::MissionClock(const Problem& problem, const Path& path) : acceleration_(problem.robot().acceleration) {
  const Robot& robot = problem.robot();
  std::vector<std::size_t> stops;  // the intervals that begin at rest
  double driven = 0;
  Point heading(0, 0);  // at the end of the part before
  for (const Part part : parts_of_one_gear(path)) {
    SmoothPath smooth(part, kHalfWidth * robot.tool_width);
    if (!(smooth.length() > 0)) continue;
    if (!intervals_.empty()) intervals_.back().turn = turn_between(heading, first_heading(part));
    stops.push_back(intervals_.size());
    Sampler(smooth, robot, driven, intervals_).run();
    stops.push_back(intervals_.size() - 1);
    driven += smooth.length();
    heading = last_heading(part);
  }
  if (intervals_.empty()) return;
  find_speeds(stops);
  for (std::size_t i = 0; i + 1 < intervals_.size(); ++i) {
    Interval& here = intervals_[i];
    here.begin_s = total_;
    const double drive = seconds(here.length, here.speed, intervals_[i + 1].speed, here.top, acceleration_);
    double driving = here.turn;  // turned while driving
    if (robot.min_turn_radius > 0) driving = std::min(driving, here.length / robot.min_turn_radius);
    total_ += std::max(drive, driving / robot.turn_rate) + (here.turn - driving) / robot.turn_rate;
  }
  intervals_.back().begin_s = total_;
}

/// From the limits at the samples to speeds: at rest at the stops, and by the acceleration in both directions.
void MissionClock::find_speeds(const std::vector<std::size_t>& stops) {
  const double twice = 2 * acceleration_;
  const std::size_t last = intervals_.size() - 1;
  for (std::size_t i = 0; i < last; ++i) intervals_[i].top = std::max(intervals_[i].speed, intervals_[i + 1].speed);
  for (const std::size_t stop : stops) intervals_[stop].speed = 0;
  const auto slow_down = [&](std::size_t from, std::size_t to, double length) {
    const double v = intervals_[from].speed;
    intervals_[to].speed = std::min(intervals_[to].speed, std::sqrt(v * v + twice * length));
  };
  for (std::size_t i = 0; i < last; ++i) slow_down(i, i + 1, intervals_[i].length);
  for (std::size_t i = last; i-- > 0;) slow_down(i + 1, i, intervals_[i].length);
}

double MissionClock::at(double path_m) const {
  if (intervals_.empty() || path_m <= 0) return 0;
  const auto after = std::lower_bound(intervals_.begin(), intervals_.end(), path_m,
                                      [](const Interval& i, double m) { return i.path_m < m; });
  if (after == intervals_.end()) return total_;
  const Interval &here = *std::prev(after), &next = *after;  // the first begins at 0, so there is one before
  const double part = (path_m - here.path_m) / (next.path_m - here.path_m), whole_s = next.begin_s - here.begin_s;
  const double drive = seconds(here.length, here.speed, next.speed, here.top, acceleration_);
  if (!(drive > 0)) return here.begin_s + part * whole_s;
  const double driven =
      seconds_of_part(part * here.length, here.length, here.speed, next.speed, here.top, acceleration_);
  return here.begin_s + std::min(1.0, driven / drive) * whole_s;
}

}  // namespace oxturn
