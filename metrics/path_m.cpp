// Length of the whole path, metres: work_m + transit_m.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kPathM;

const Metric kPathM{"path_m", "m", Better::lower, "length of the whole path",
                    [](const Scored& s) -> std::optional<double> { return s.path.length(); }};

}  // namespace oxturn
