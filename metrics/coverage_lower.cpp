// Certified lower bound of coverage, 0 to 1: the swath is replaced by inscribed polygons (swept_area.hpp).
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kCoverageLower;

const Metric kCoverageLower{"coverage_lower", "1", Better::higher, "coverage is certainly not below this",
                            [](const Scored& s) -> std::optional<double> { return s.swept.coverage.lower; }};

}  // namespace oxturn
