// Share of all free space that is covered target, 0 to 1:
//   area(target n swath) / area(free space),   estimated (swept_area.hpp)
// Free space counts whether the robot can reach it or not.
#include <algorithm>

#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kCoverageOfFree;

const Metric kCoverageOfFree{"coverage_of_free", "1", Better::higher,
                             "covered target over all free space, reachable or not",
                             [](const Scored& s) -> std::optional<double> {
                               return std::min(1.0, s.swept.covered_estimate_m2 / area(s.problem.map().free));
                             }};

}  // namespace oxturn
