// Certified upper bound of coverage, 0 to 1: the swath is replaced by circumscribed polygons (swept_area.hpp).
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kCoverageUpper;

const Metric kCoverageUpper{"coverage_upper", "1", Better::higher, "coverage is certainly not above this",
                            [](const Scored& s) -> std::optional<double> { return s.swept.coverage.upper; }};

}  // namespace oxturn
