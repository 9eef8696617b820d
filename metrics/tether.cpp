#include "metrics/tether.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "maps/followed_path.hpp"
#include "metrics/tether_crossings.hpp"
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kTetherLimit, kTetherMax, kTetherBendsMax, kTetherAngleMin, kTetherAngleMean, kTetherSharp;
extern const Metric kTetherCrossings, kTetherEntangled;

namespace {

/// Integral of atan2(h, s) over s.
double angle_integral(const TetherStretch& t) {
  const double h = t.height;
  const auto whole = [h](double s) { return s * std::atan2(h, s) + (h > 0 ? h * std::log(std::hypot(h, s)) : 0.0); };
  return whole(t.end) - whole(t.begin);
}

/// Metres of the stretch with atan2(h, s) > limit, that is s < h cot(limit).
double sharp_metres(const TetherStretch& t, double limit) {
  if (limit >= kPi) return 0;
  const double until = t.height * std::cos(limit) / std::sin(limit);
  return std::clamp(until, t.begin, t.end) - t.begin;
}

}  // namespace

void drive_tether(const Problem& problem, const Polyline& way, const TetherVisitor& visitor) {
  TautTether string = tether_at_start(problem);
  OwnLine own_line;
  double driven = 0;
  for (const Point& to : way) {
    const Point from = string.robot();
    const double length = distance(from, to);
    if (!(length > 0)) continue;
    if (visitor.crossing)
      for (const Point& at : own_line.crossed(string, to)) visitor.crossing({driven + distance(from, at), at});
    const Point heading = (to - from) / length;
    string.drive(to, [&](const TautTether::Swing& swing) {
      if (!visitor.stretch) return;
      TetherStretch stretch{swing, heading, driven + distance(from, swing.from), 0, 0, 0};
      stretch.begin = (swing.from - swing.pivot).dot(heading);
      stretch.end = std::max(stretch.begin, (swing.to - swing.pivot).dot(heading));
      stretch.height = std::abs(cross(heading, from - swing.pivot));
      visitor.stretch(stretch);
    });
    driven += length;
    if (visitor.waypoint) visitor.waypoint(string, driven);
  }
}

std::optional<TetherRun> tether_run(const Problem& problem, const Path& path, const EdgeIndex& walls) {
  const FollowedPath way = followed_path(problem, path, walls);
  if (!way.whole) return std::nullopt;
  const TautTether first = tether_at_start(problem);
  TetherRun run;
  run.longest_m = run.end_m = first.length();
  run.longest_at = problem.start();
  run.bends_max = first.bends().size();
  run.angle_min = kPi;
  const double limit = problem.robot().tether->sharp_angle;
  const auto lengthen = [&](double length, const Point& at) {
    if (length <= run.longest_m) return;
    run.longest_m = length;
    run.longest_at = at;
  };
  drive_tether(problem, way.points,
               {[&](const TetherCrossing& crossing) { run.crossings.push_back(crossing); },
                [&](const TetherStretch& t) {
                  lengthen(t.length_at(t.begin), t.swing.from);
                  lengthen(t.length_at(t.end), t.swing.to);
                  run.bends_max = std::max(run.bends_max, t.swing.bends);
                  run.angle_min = std::min(run.angle_min, t.angle_at(t.end));
                  run.angle_sum += angle_integral(t);
                  run.sharp_m += sharp_metres(t, limit);
                },
                [&](const TautTether& string, double path_m) {
                  lengthen(string.length(), string.robot());
                  run.bends_max = std::max(run.bends_max, string.bends().size());
                  run.path_m = path_m;
                  run.end_m = string.length();
                }});
  run.geodesic_m = problem.tether()->geodesics().distance(way.points.back());
  return run;
}

std::string find_tether_flaw(const Problem& problem, const std::optional<TetherRun>& run) {
  if (!run) return "leaves free space, no tether can follow it";
  const double limit = problem.robot().tether->length;
  if (run->longest_m <= limit + problem.tolerance() + 1e-9 * limit) return "";
  return fmt::format("pulls its tether to {:.6g} m at ({:.6g}, {:.6g}), {:.3g} m over its limit {:.6g} m",
                     run->longest_m, run->longest_at.x(), run->longest_at.y(), run->longest_m - limit, limit);
}

#define OXTURN_NO_TETHER "empty: no tether, or the path jumps or leaves free space"

const Metric kTetherLimit{"tether_limit_m", "m", Better::neither, "length of the robot's tether; empty: no tether",
                          [](const Scored& s) -> std::optional<double> {
                            const auto& tether = s.problem.robot().tether;
                            return tether ? std::optional(tether->length) : std::nullopt;
                          }};

const Metric kTetherMax{"tether_max_m", "m", Better::lower, "longest taut tether along the path; " OXTURN_NO_TETHER,
                        [](const Scored& s) { return s.tether ? std::optional(s.tether->longest_m) : std::nullopt; }};

const Metric kTetherBendsMax{"tether_bends_max", "count", Better::lower,
                             "most corners that the tether bends about; " OXTURN_NO_TETHER,
                             [](const Scored& s) -> std::optional<double> {
                               if (!s.tether) return std::nullopt;
                               return static_cast<double>(s.tether->bends_max);
                             }};

const Metric kTetherAngleMin{"tether_angle_min_rad", "rad", Better::neither,
                             "least angle between heading and tether, 0: straight away from its pull; empty as "
                             "tether_max_m, or no length",
                             [](const Scored& s) -> std::optional<double> {
                               if (!s.tether || !(s.tether->path_m > 0)) return std::nullopt;
                               return s.tether->angle_min;
                             }};

const Metric kTetherAngleMean{
    "tether_angle_mean_rad", "rad", Better::neither,
    "mean over the path of the angle between heading and tether; empty as tether_max_m, or no "
    "length",
    [](const Scored& s) -> std::optional<double> {
      if (!s.tether || !(s.tether->path_m > 0)) return std::nullopt;
      return s.tether->angle_sum / s.tether->path_m;
    }};

const Metric kTetherSharp{
    "tether_sharp_fraction", "1", Better::lower,
    "share of the path with an angle above the tether's sharp_angle; empty as tether_max_m, or no "
    "length",
    [](const Scored& s) -> std::optional<double> {
      if (!s.tether || !(s.tether->path_m > 0)) return std::nullopt;
      return s.tether->sharp_m / s.tether->path_m;
    }};

const Metric kTetherCrossings{"tether_crossings", "count", Better::lower,
                              "places where the robot drives over its own tether; " OXTURN_NO_TETHER,
                              [](const Scored& s) -> std::optional<double> {
                                if (!s.tether) return std::nullopt;
                                return static_cast<double>(s.tether->crossings.size());
                              }};

const Metric kTetherEntangled{"tether_entangled", "count", Better::lower,
                              "1 if the tether ends longer than the shortest way to where it ends, else 0; empty as "
                              "tether_max_m",
                              [](const Scored& s) -> std::optional<double> {
                                if (!s.tether || !std::isfinite(s.tether->geodesic_m)) return std::nullopt;
                                const double shortest = s.tether->geodesic_m;
                                const double slack = 1e-6 * shortest + s.problem.tolerance();
                                return s.tether->end_m > shortest + slack ? 1 : 0;
                              }};

#undef OXTURN_NO_TETHER

}  // namespace oxturn
