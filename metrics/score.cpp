#include "metrics/score.hpp"

#include <cmath>

#include "metrics/walls.hpp"

namespace oxturn {

extern const Metric kCoverage, kCoverageLower, kCoverageUpper, kCoverageOfFree, kTargetM2;
extern const Metric kPathM, kWorkM, kTransitM, kLengthRatio, kOverlap, kRevisits;
extern const Metric kTurns, kTurnRad, kClearanceM, kMissionS;
extern const Metric kTetherLimit, kTetherMax, kTetherBendsMax, kTetherAngleMin, kTetherAngleMean, kTetherSharp;
extern const Metric kTetherCrossings, kTetherEntangled;

const std::vector<const Metric*>& metrics() {
  static const std::vector<const Metric*> all{
      &kCoverage,       &kCoverageLower,   &kCoverageUpper, &kCoverageOfFree,  &kTargetM2,        &kPathM,
      &kWorkM,          &kTransitM,        &kLengthRatio,   &kOverlap,         &kRevisits,        &kTurns,
      &kTurnRad,        &kClearanceM,      &kMissionS,      &kTetherLimit,     &kTetherMax,       &kTetherBendsMax,
      &kTetherAngleMin, &kTetherAngleMean, &kTetherSharp,   &kTetherCrossings, &kTetherEntangled,
  };
  return all;
}

std::optional<double> Score::value(const std::string& metric) const {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (metrics()[i]->name == metric) return values[i];
  return std::nullopt;
}

namespace {

bool measurable(const Path& path) {
  bool any = false;
  for (const Leg& leg : path.legs) {
    any = any || !leg.points.empty();
    for (const Point& p : leg.points)
      if (!finite(p)) return false;
  }
  return any && std::isfinite(path.length());  // coordinates of 1e200 are finite, their distances are not
}

}  // namespace

Score score(const Problem& problem, const Path& path, const ScoreOptions& options) {
  Score result;
  result.values.resize(metrics().size());
  const EdgeIndex walls(problem.map().free);
  result.flaw = find_flaw(problem, path, walls);
  if (!measurable(path)) return result;
  std::optional<TetherRun> tether;
  if (problem.robot().tether) {
    tether = tether_run(problem, path, walls);
    if (result.flaw.empty() && options.tether_counts) result.flaw = find_tether_flaw(problem, tether);
  }
  const SweptArea swept = swept_area(problem.target(), problem.target_excess(), problem.robot().tool_width, path);
  const Scored scored{problem, path, swept, clearance(problem, path, walls), tether ? &*tether : nullptr};
  for (std::size_t i = 0; i < metrics().size(); ++i) result.values[i] = metrics()[i]->compute(scored);
  return result;
}

std::string find_flaw(const Problem& problem, const Path& path, const ScoreOptions& options) {
  const EdgeIndex walls(problem.map().free);
  const std::string flaw = find_flaw(problem, path, walls);
  if (!flaw.empty() || !options.tether_counts || !problem.robot().tether) return flaw;
  return find_tether_flaw(problem, tether_run(problem, path, walls));
}

}  // namespace oxturn
