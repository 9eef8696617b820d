// Time to drive the path, seconds: corners rounded, slower in bends, limited acceleration. Model: see mission.hpp.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kMissionS;

const Metric kMissionS{"mission_s", "s", Better::lower,
                       "time to drive the path with rounded corners, in bends no faster than the turn rate allows",
                       [](const Scored& s) -> std::optional<double> { return s.clock->total(); }};

}  // namespace oxturn
