// Greatest length of the taut tether along the path, metres (tether.hpp). Empty as all metrics of the tether: without a
// tether, and if none can follow the path, because it jumps or leaves free space.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kTetherMaxM;

const Metric kTetherMaxM{"tether_max_m", "m", Better::lower,
                         "longest taut tether along the path; empty: no tether, or the path jumps or leaves free space",
                         [](const Scored& s) { return s.tether ? std::optional(s.tether->longest_m) : std::nullopt; }};

}  // namespace oxturn
