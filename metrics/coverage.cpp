// Share of the target that the tool sweeps, with certified bounds (swept.hpp), and the target's size.
#include <algorithm>

#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kCoverage, kCoverageLower, kCoverageUpper, kCoverageOfFree, kTargetM2;

const Metric kCoverage{"coverage", "1", Better::higher, "share of the target covered: middle of the certified interval",
                       [](const Scored& s) -> std::optional<double> { return s.swept.coverage.middle(); }};

const Metric kCoverageLower{"coverage_lower", "1", Better::higher, "coverage is certainly not below",
                            [](const Scored& s) -> std::optional<double> { return s.swept.coverage.lower; }};

const Metric kCoverageUpper{"coverage_upper", "1", Better::higher, "coverage is certainly not above",
                            [](const Scored& s) -> std::optional<double> { return s.swept.coverage.upper; }};

const Metric kCoverageOfFree{"coverage_of_free", "1", Better::higher,
                             "covered target over all free space, reachable or not",
                             [](const Scored& s) -> std::optional<double> {
                               return std::min(1.0, s.swept.seen_m2 / area(s.problem.map().free));
                             }};

const Metric kTargetM2{"target_m2", "m2", Better::neither, "area that can be covered",
                       [](const Scored& s) -> std::optional<double> { return area(s.problem.target()); }};

}  // namespace oxturn
