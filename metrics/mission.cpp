#include "metrics/mission.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
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
constexpr double kKept = 0.5;         // tool widths between the times that are kept
constexpr double kWholeSteps = 1e-6;  // rounding of a number of steps

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
  Sampler(SmoothPath& path, const Robot& robot, double before, DriveTimes& out)
      : path_(path), robot_(robot), before_(before), out_(out) {}

  void run() {
    const double reach = 2 * path_.half_width();
    const std::vector<double>& bends = path_.bends();
    last_ = sample(-reach);
    double from = -reach, to = -reach;  // of consecutive bends whose windows overlap
    for (const double bend : bends) {
      if (bend - reach > to) {
        add_window(from, to);
        const Sample next = sample(bend - reach);
        advance(next, turn_to(next));
        from = bend - reach;
      }
      to = bend + reach;
    }
    add_window(from, to);
    add(0, 0, true);
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
    const double turn = turn_to(next);
    if (turn > kMostTurn && next.s - last_.s > kLeastStep * path_.half_width()) {
      refine(sample((last_.s + next.s) / 2));
      refine(next);
      return;
    }
    advance(next, turn);
  }

  /// From the last heading; 0 if there is none.
  double turn_to(const Sample& next) const {
    return next.heads ? turn_between(last_.heads ? last_.state.first : heading_, next.state.first) : 0;
  }

  void advance(Sample next, double turn) {
    if (last_.heads) heading_ = last_.state.first;
    const double length = (next.state.progress - last_.state.progress) * (last_.stretch + next.stretch) / 2;
    if (turn > 2 * kMostTurn) {  // too fast to be sampled: it turns on the spot
      const double most = limit(length / turn);
      last_.limit = std::min(last_.limit, most);
      next.limit = std::min(next.limit, most);
    }
    add(length, turn, starts_);
    starts_ = false;
    last_ = next;
  }

  /// The last sample, and what follows it.
  void add(double length, double turn, bool at_rest) {
    out_.add({before_ + last_.state.progress, last_.limit, length, turn, at_rest});
  }

  SmoothPath& path_;
  const Robot& robot_;
  double before_;
  DriveTimes& out_;
  bool starts_ = true;
  Sample last_{};
  Point heading_{0, 0};  // the last one
};

MissionClock::MissionClock(const Problem& problem, const Path& path)
    : times_(problem.robot(), kKept * problem.robot().tool_width) {
  const Robot& robot = problem.robot();
  double driven = 0;
  std::optional<Point> heading;  // at the end of the part before
  for (const Part part : parts_of_one_gear(path)) {
    SmoothPath smooth(part, kHalfWidth * robot.tool_width);
    if (!(smooth.length() > 0)) continue;
    if (heading) times_.turn_at_rest(turn_between(*heading, first_heading(part)));
    Sampler(smooth, robot, driven, times_).run();
    driven += smooth.length();
    heading = last_heading(part);
  }
  times_.finish();
}

}  // namespace oxturn
