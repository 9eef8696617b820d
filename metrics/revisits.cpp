// Mean over the target of how often a point is visited again: max(visits - 1, 0), so a point never visited counts
// 0, not -1. A visit is a maximal stretch of path during which the point is under the tool.
#include <algorithm>

#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kRevisits;

const Metric kRevisits{"revisits", "1", Better::lower, "mean over the target of visits after the first",
                       [](const Scored& s) -> std::optional<double> {
                         return std::max(0.0, s.swept.visits_m2 - s.swept.seen_m2) / area(s.problem.target());
                       }};

}  // namespace oxturn
