// Greatest number of corners about which the taut tether bends at one time (tether.hpp). Empty as tether_max_m.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kTetherBendsMax;

const Metric kTetherBendsMax{"tether_bends_max", "count", Better::lower,
                             "most corners about which the tether bends; empty as tether_max_m",
                             [](const Scored& s) -> std::optional<double> {
                               if (!s.tether) return std::nullopt;
                               return static_cast<double>(s.tether->bends_max);
                             }};

}  // namespace oxturn
