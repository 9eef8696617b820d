// How much of the work was done twice, 0 for none:
//   work_m * w / (area swept with the tool on) - 1,   w = tool width
// It depends on the curve that is driven, not on how it is cut into legs. What a path sweeps at its ends can make it
// negative; then it is 0. Estimated (swept_area.hpp). Empty if the tool is never on.
#include <algorithm>

#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kOverlap;

const Metric kOverlap{"overlap", "1", Better::lower,
                      "work length times tool width over the area swept, less 1; empty: the tool is never on",
                      [](const Scored& s) -> std::optional<double> {
                        if (!(s.swept.union_m2 > 0)) return std::nullopt;
                        return std::max(0.0, s.swept.work_m2 / s.swept.union_m2 - 1);
                      }};

}  // namespace oxturn
