#include "metrics/tether.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/math.hpp"
#include "metrics/crossing_detector.hpp"

namespace oxturn {
namespace {

/// Integral of the angle over s.
double angle_integral(const PivotMotion& m) {
  const double h = m.height;
  const auto antiderivative = [h](double s) {
    return s * math::atan2(h, s) + (h > 0 ? h * math::log(math::hypot(h, s)) : 0.0);
  };
  const double forward = antiderivative(m.end) - antiderivative(m.begin);
  return m.gear == Gear::forward ? forward : kPi * (m.end - m.begin) - forward;
}

/// Metres of the motion with atan2(h, s) > limit, that is s < h cot(limit); in reverse with -s in place of s.
double sharp_metres(const PivotMotion& m, double limit) {
  if (limit >= kPi) return 0;
  const double until = m.height * math::cos(limit) / math::sin(limit);
  if (m.gear == Gear::reverse) return m.end - std::clamp(-until, m.begin, m.end);
  return std::clamp(until, m.begin, m.end) - m.begin;
}

void lengthen(TetherRun& run, double length, const Point& at) {
  if (length <= run.longest_m) return;
  run.longest_m = length;
  run.longest_at = at;
}

void add(TetherRun& run, const PivotMotion& m, double sharp_angle) {
  lengthen(run, m.length_at(m.begin), m.swing.from);
  lengthen(run, m.length_at(m.end), m.swing.to);
  run.bends_max = std::max(run.bends_max, m.swing.bends);
  run.angle_min = std::min(run.angle_min, m.angle_at(m.gear == Gear::forward ? m.end : m.begin));
  run.angle_sum += angle_integral(m);
  run.sharp_m += sharp_metres(m, sharp_angle);
}

TetherRun run_at_start(const Problem& problem) {
  const TautTether tether = tether_at_start(problem);
  TetherRun run;
  run.longest_m = run.end_m = tether.length();
  run.longest_at = problem.start();
  run.bends_max = tether.bends().size();
  run.angle_min = kPi;
  return run;
}

}  // namespace

void drive_tether(const Problem& problem, const FollowedPath& path, const TetherVisitor& visitor) {
  TautTether tether = tether_at_start(problem);
  CrossingDetector detector(problem.tolerance());
  double driven = 0;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const Point &to = path.points[i], from = tether.robot();
    const double length = distance(from, to);
    if (!(length > 0)) continue;
    if (visitor.crossing)
      for (const Point& at : detector.crossings(tether, to)) visitor.crossing({driven + distance(from, at), at});
    const Point direction = (to - from) / length;
    const Gear gear = i > 0 ? path.gears[i - 1] : Gear::forward;
    tether.drive(to, [&](const TautTether::Swing& swing) {
      if (!visitor.motion) return;
      PivotMotion motion{swing, direction, gear, driven + distance(from, swing.from), 0, 0, 0};
      motion.begin = (swing.from - swing.pivot).dot(direction);
      motion.end = std::max(motion.begin, (swing.to - swing.pivot).dot(direction));
      motion.height = std::abs(cross(direction, from - swing.pivot));
      visitor.motion(motion);
    });
    driven += length;
    if (visitor.vertex) visitor.vertex(tether, driven);
  }
}

std::optional<TetherRun> tether_run(const Problem& problem, const Path& path, const EdgeIndex& walls,
                                    double tolerance) {
  const FollowedPath followed = followed_path(problem, path, walls, tolerance);
  if (!followed.whole) return std::nullopt;
  TetherRun run = run_at_start(problem);
  const double sharp_angle = problem.robot().tether->sharp_angle;
  TetherVisitor visitor;
  visitor.crossing = [&](const TetherCrossing& crossing) { run.crossings.push_back(crossing); };
  visitor.motion = [&](const PivotMotion& motion) { add(run, motion, sharp_angle); };
  visitor.vertex = [&](const TautTether& tether, double path_m) {
    lengthen(run, tether.length(), tether.robot());
    run.bends_max = std::max(run.bends_max, tether.bends().size());
    run.path_m = path_m;
    run.end_m = tether.length();
  };
  drive_tether(problem, followed, visitor);
  run.geodesic_m = problem.tether()->geodesics().distance(followed.points.back());
  return run;
}

std::string find_tether_flaw(const Problem& problem, const std::optional<TetherRun>& run, double tolerance) {
  if (!run) return "leaves free space, no tether can follow it";
  const double limit = problem.robot().tether->length;
  if (run->longest_m <= limit + tolerance + 1e-9 * limit) return "";
  return fmt::format("pulls its tether to {:.6g} m at ({:.6g}, {:.6g}), {:.3g} m over its limit {:.6g} m",
                     run->longest_m, run->longest_at.x(), run->longest_at.y(), run->longest_m - limit, limit);
}

}  // namespace oxturn
