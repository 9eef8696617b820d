// Time to drive the path, seconds: trapezoidal speed profile, stops and turns at corners, slower in curves. Model: see
// mission.hpp.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kMissionS;

const Metric kMissionS{"mission_s", "s", Better::lower, "time to drive the path, stopping at corners",
                       [](const Scored& s) -> std::optional<double> { return s.clock->total(); }};

}  // namespace oxturn
