// How often a point of the target is visited again, on average over the whole target:
//   integral over the target of max(visits(p) - 1, 0) / area(target)
// A visit of p is a maximal part of the path during which p is under the tool. Points never visited count 0. Estimated
// (swept_area.hpp).
#include <algorithm>

#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kRevisits;

const Metric kRevisits{"revisits", "1", Better::lower, "mean over the target of visits after the first",
                       [](const Scored& s) -> std::optional<double> {
                         return std::max(0.0, s.swept.visits_m2 - s.swept.covered_estimate_m2) /
                                area(s.problem.target());
                       }};

}  // namespace oxturn
