// Area of the largest connected piece of the target that is certainly not covered, square metres. Pieces up to a
// hundredth of the tool's disc (pi w^2 / 400, w = tool width) are ignored.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kMissedLargestM2;

const Metric kMissedLargestM2{"missed_largest_m2", "m2", Better::lower,
                              "area of the largest uncovered piece; 0: none above a hundredth of the tool's disc",
                              [](const Scored& s) -> std::optional<double> {
                                return s.swept.missed.empty() ? 0 : s.swept.missed.front().area_m2;
                              }};

}  // namespace oxturn
