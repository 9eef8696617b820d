// How much the legs sweep over each other's area: (sum of the legs' own swept areas / area of their union) - 1.
// A leg that crosses itself counts that area once; see revisits for the other view.
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
