// How much the legs cover again of each other's area, 0 for disjoint legs:
//   (sum over legs with the tool on of area(swath of the leg)) / area(union of these swaths) - 1
// A leg that crosses itself counts that area once; `revisits` counts it again. Estimated (swept_area.hpp). Empty if the
// tool is never on.
#include <algorithm>

#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kOverlap;

const Metric kOverlap{"overlap", "1", Better::lower,
                      "legs' own swept areas over their union, less 1; empty: the tool is never on",
                      [](const Scored& s) -> std::optional<double> {
                        if (!(s.swept.union_m2 > 0)) return std::nullopt;
                        return std::max(0.0, s.swept.legs_m2 / s.swept.union_m2 - 1);
                      }};

}  // namespace oxturn
