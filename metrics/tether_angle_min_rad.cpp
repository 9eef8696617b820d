// Least angle between the robot's heading and the direction away from the tether's pull, radians, 0 to pi (tether.hpp).
// Empty as tether_max_m, and for a path without length.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kTetherAngleMinRad;

const Metric kTetherAngleMinRad{"tether_angle_min_rad", "rad", Better::neither,
                                "least angle between heading and tether, 0: straight away from its pull; empty as "
                                "tether_max_m, or no length",
                                [](const Scored& s) -> std::optional<double> {
                                  if (!s.tether || !(s.tether->path_m > 0)) return std::nullopt;
                                  return s.tether->angle_min;
                                }};

}  // namespace oxturn
