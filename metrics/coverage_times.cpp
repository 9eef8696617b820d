// Metres driven, and seconds (mission.hpp), until 90, 95 and 99 % of the target were covered: lengths and times of
// planners are compared at equal coverage. By the curve of covered target over path length (coverage_curve.hpp).
#include <algorithm>

#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kPath90M, kPath95M, kPath99M, kMission90S, kMission95S, kMission99S;

namespace {

std::optional<double> metres_until(const std::vector<CoveragePoint>& curve, double coverage) {
  const auto reached = std::lower_bound(curve.begin(), curve.end(), coverage,
                                        [](const CoveragePoint& p, double share) { return p.coverage < share; });
  if (reached == curve.end()) return std::nullopt;
  if (reached == curve.begin()) return reached->path_m;
  const CoveragePoint &from = *std::prev(reached), &to = *reached;
  const double part = (coverage - from.coverage) / (to.coverage - from.coverage);
  return from.path_m + part * (to.path_m - from.path_m);
}

Metric path_until(int percent) {
  return {"path_" + std::to_string(percent) + "_m", "m", Better::lower,
          "path length until " + std::to_string(percent) + " % of the target were covered; empty: never",
          [percent](const Scored& s) { return metres_until(s.swept.curve, percent / 100.0); }};
}

Metric mission_until(int percent) {
  return {"mission_" + std::to_string(percent) + "_s", "s", Better::lower,
          "time until " + std::to_string(percent) + " % of the target were covered; empty: never",
          [percent](const Scored& s) -> std::optional<double> {
            const auto metres = metres_until(s.swept.curve, percent / 100.0);
            if (!metres) return std::nullopt;
            return s.clock->at(*metres);
          }};
}

}  // namespace

const Metric kPath90M = path_until(90), kPath95M = path_until(95), kPath99M = path_until(99);
const Metric kMission90S = mission_until(90), kMission95S = mission_until(95), kMission99S = mission_until(99);

}  // namespace oxturn
