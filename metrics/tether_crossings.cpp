// How often the robot drives over its own taut tether. What counts as a crossing: crossing_detector.hpp. Empty as
// tether_max_m.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kTetherCrossings;

const Metric kTetherCrossings{"tether_crossings", "count", Better::lower,
                              "how often the robot drives over its own tether; empty as tether_max_m",
                              [](const Scored& s) -> std::optional<double> {
                                if (!s.tether) return std::nullopt;
                                return static_cast<double>(s.tether->crossings.size());
                              }};

}  // namespace oxturn
