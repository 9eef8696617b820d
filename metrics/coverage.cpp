// Share of the target that the tool sweeps, 0 to 1:
//   area(target n swath) / area(target),   swath = points within w / 2 of the path while the tool is on, w = tool width
// The middle of the certified interval [coverage_lower, coverage_upper] (swept_area.hpp).
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kCoverage;

const Metric kCoverage{"coverage", "1", Better::higher, "share of the target covered: middle of the certified interval",
                       [](const Scored& s) -> std::optional<double> { return s.swept.coverage.middle(); }};

}  // namespace oxturn
