// How often a point of the target that is visited is visited again, on average:
//   integral over the target of visits(p) / area(visited target) - 1
// A visit of p is a maximal part of the path during which p is under the tool. Estimated (swept_area.hpp). Empty if no
// point of the target is visited.
#include <algorithm>

#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kRevisits;

const Metric kRevisits{"revisits", "1", Better::lower,
                       "mean over the visited target of visits after the first; empty: nothing is visited",
                       [](const Scored& s) -> std::optional<double> {
                         if (!(s.swept.covered_estimate_m2 > 0)) return std::nullopt;
                         return std::max(0.0, s.swept.visits_m2 / s.swept.covered_estimate_m2 - 1);
                       }};

}  // namespace oxturn
