// Length of the legs with the tool on, metres.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kWorkM;

const Metric kWorkM{"work_m", "m", Better::lower, "length driven with the tool on",
                    [](const Scored& s) -> std::optional<double> { return s.path.length(true); }};

}  // namespace oxturn
