// Length of the robot's tether, metres. Empty without a tether.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kTetherLimitM;

const Metric kTetherLimitM{"tether_limit_m", "m", Better::neither, "length of the robot's tether; empty: no tether",
                           [](const Scored& s) -> std::optional<double> {
                             const auto& tether = s.problem.robot().tether;
                             return tether ? std::optional(tether->length) : std::nullopt;
                           }};

}  // namespace oxturn
