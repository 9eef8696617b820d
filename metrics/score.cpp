#include "metrics/score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "metrics/legs_join.hpp"
#include "metrics/walls.hpp"

namespace oxturn {

// One metric a file, named as its column.
extern const Metric kCoverage, kCoverageLower, kCoverageUpper, kCoverageOfFree, kTargetM2;
extern const Metric kPathM, kWorkM, kTransitM, kLengthRatio, kBoundM, kBoundKind, kGap, kOverlap, kRevisits;
extern const Metric kPromiseCoverage, kPath90M, kPath95M, kPath99M, kMission90S, kMission95S, kMission99S;
extern const Metric kMissedPieces, kMissedLargestM2;
extern const Metric kTurns, kTurnRad, kCurvatureMaxPerM, kCurvatureViolations, kCusps, kClearanceM, kMissionS;
extern const Metric kTetherLimitM, kTetherMaxM, kTetherBendsMax, kTetherAngleMinRad, kTetherAngleMeanRad;
extern const Metric kTetherSharpFraction, kTetherCrossings, kTetherEntangled;
extern const Metric kStrokeShare, kStrokeErrorM, kFillShare, kFillShareReachable, kSpillM2, kToolUpM, kOverFinishedM;
extern const Metric kWorkOverFinishedM, kTangentBreaks;

Metrics built_in_metrics() {
  return Metrics("metric", {kCoverage,
                            kCoverageLower,
                            kCoverageUpper,
                            kCoverageOfFree,
                            kTargetM2,
                            kPathM,
                            kWorkM,
                            kTransitM,
                            kLengthRatio,
                            kBoundM,
                            kBoundKind,
                            kGap,
                            kOverlap,
                            kRevisits,
                            kPromiseCoverage,
                            kPath90M,
                            kPath95M,
                            kPath99M,
                            kMission90S,
                            kMission95S,
                            kMission99S,
                            kMissedPieces,
                            kMissedLargestM2,
                            kTurns,
                            kTurnRad,
                            kCurvatureMaxPerM,
                            kCurvatureViolations,
                            kCusps,
                            kClearanceM,
                            kMissionS,
                            kTetherLimitM,
                            kTetherMaxM,
                            kTetherBendsMax,
                            kTetherAngleMinRad,
                            kTetherAngleMeanRad,
                            kTetherSharpFraction,
                            kTetherCrossings,
                            kTetherEntangled,
                            kStrokeShare,
                            kStrokeErrorM,
                            kFillShare,
                            kFillShareReachable,
                            kSpillM2,
                            kToolUpM,
                            kOverFinishedM,
                            kWorkOverFinishedM,
                            kTangentBreaks});
}

std::string to_text(Better better) {
  return better == Better::lower ? "lower" : better == Better::higher ? "higher" : "neither";
}

std::optional<double> Score::value(const std::string& metric) const {
  for (const MetricValue& value : values)
    if (value.name == metric) return value.value;
  return std::nullopt;
}

namespace {

constexpr std::size_t kCurvePoints = 200;
constexpr double kCurveError = 0.0045;
constexpr double kCertainty = 0.001;   // width of the coverage's interval
constexpr double kNoTolerance = 1e-4;  // tool widths: of a path that hardly leaves configuration space

/// Has points, all finite, and a finite length.
bool measurable(const Path& path) {
  bool any = false;
  for (const Leg& leg : path.legs) {
    any = any || !leg.points.empty();
    for (const Point& p : leg.points)
      if (!finite(p)) return false;
  }
  return any && std::isfinite(path.length());  // finite points can be too far apart
}

/// Points of the curve such that linear interpolation errs by at most `error`.
std::vector<CoveragePoint> thinned(const std::vector<CoveragePoint>& curve, double error) {
  std::vector<CoveragePoint> kept{curve.front()};
  double low = -std::numeric_limits<double>::infinity(),
         high = -low;  // slopes that pass all points since the last kept
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const auto slope_to = [&](double coverage) {
      return (coverage - kept.back().coverage) / (curve[i].path_m - kept.back().path_m);
    };
    const double slope = slope_to(curve[i].coverage);
    if (slope < low || slope > high) {
      kept.push_back(curve[i - 1]);
      low = -std::numeric_limits<double>::infinity(), high = -low;
    }
    low = std::max(low, slope_to(curve[i].coverage - error));
    high = std::min(high, slope_to(curve[i].coverage + error));
  }
  if (curve.size() > 1) kept.push_back(curve.back());
  return kept;
}

/// At most kCurvePoints points.
std::vector<CurvePoint> coverage_curve(const SweptArea& swept, const MissionClock& clock) {
  double error = kCurveError;
  std::vector<CoveragePoint> points = thinned(swept.curve, error);
  while (points.size() > kCurvePoints) points = thinned(swept.curve, error *= 1.1);
  std::vector<CurvePoint> result;
  result.reserve(points.size());
  for (const CoveragePoint& p : points) result.push_back({p.path_m, clock.at(p.path_m), p.coverage});
  return result;
}

/// Covered share of what is promised, certified lower bound.
std::optional<double> kept_promise(const Problem& problem, const Path& path, const SweptArea& swept,
                                   const ScoreOptions& options) {
  switch (options.promise) {
    case Promise::target:
      return swept.coverage.lower;
    case Promise::cells:
      if (options.promised == nullptr || !(area(*options.promised) > 0)) return std::nullopt;
      return coverage_of(*options.promised, 0, problem.robot().tool_width, path).lower;
    case Promise::nothing:
      break;
  }
  return std::nullopt;
}

/// A valid path of a disc that is no narrower than its tool cannot sweep anything but target.
Swath swath_of(const Problem& problem, bool valid, double tolerance) {
  const Robot& robot = problem.robot();
  const bool narrow = robot.footprint.empty() && robot.tool_width / 2 <= robot.radius;
  const bool whole = !problem.map().target_area && !problem.limited();
  return valid && narrow && whole && tolerance <= kNoTolerance * robot.tool_width ? Swath::in_target : Swath::anywhere;
}

}  // namespace

Score score(const Problem& problem, const Path& path, const Metrics& metrics, const ScoreOptions& options) {
  Score result;
  for (const Metric& metric : metrics) result.values.push_back({metric.name, std::nullopt});
  const EdgeIndex& walls = problem.map_edges();
  const double tolerance = problem.tolerance() + options.tolerance;
  result.flaw = find_flaw(problem, path, walls, tolerance);
  if (!measurable(path)) return result;
  std::optional<TetherRun> tether;
  if (problem.robot().tether) {
    tether = tether_run(problem, path, walls, tolerance);
    if (result.flaw.empty() && options.tether_counts) result.flaw = find_tether_flaw(problem, tether, tolerance);
  }
  SweptArea swept = swept_area(problem.target(), problem.target_excess(), problem.robot().tool_width, path, kCertainty,
                               options.outlines, swath_of(problem, result.flaw.empty(), tolerance));
  const MissionClock clock(problem, path);
  const Scored scored{
      problem,
      path,
      swept,
      clearance(problem, path, walls),
      tether ? &*tether : nullptr,
      &clock,
      tolerance,
      legs_join(path, tolerance) ? length_bound(problem, path, swept, result.flaw.empty()) : std::nullopt,
      kept_promise(problem, path, swept, options)};
  std::size_t i = 0;
  for (const Metric& metric : metrics) result.values[i++].value = metric.compute(scored);
  result.curve = coverage_curve(swept, clock);
  result.missed = std::move(swept.missed);
  return result;
}

Score score(const Problem& problem, const Path& path, const ScoreOptions& options) {
  return score(problem, path, built_in_metrics(), options);
}

std::string find_flaw(const Problem& problem, const Path& path, const ScoreOptions& options) {
  const EdgeIndex& walls = problem.map_edges();
  const double tolerance = problem.tolerance() + options.tolerance;
  std::string flaw = find_flaw(problem, path, walls, tolerance);
  if (!flaw.empty() || !options.tether_counts || !problem.robot().tether) return flaw;
  return find_tether_flaw(problem, tether_run(problem, path, walls, tolerance), tolerance);
}

}  // namespace oxturn
