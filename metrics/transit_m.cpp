// Length of the legs with the tool off, metres.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kTransitM;

const Metric kTransitM{"transit_m", "m", Better::lower, "length driven with the tool off",
                       [](const Scored& s) -> std::optional<double> { return s.path.length(false); }};

}  // namespace oxturn
