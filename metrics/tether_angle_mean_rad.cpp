// Mean over the path's length of the angle between heading and tether (as in tether_angle_min_rad), radians:
//   integral of the angle over the path / length of the path,   in closed form (tether.hpp)
// Empty as tether_angle_min_rad.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kTetherAngleMeanRad;

const Metric kTetherAngleMeanRad{
    "tether_angle_mean_rad", "rad", Better::neither,
    "mean over the path of the angle between heading and tether; empty as tether_max_m, or no length",
    [](const Scored& s) -> std::optional<double> {
      if (!s.tether || !(s.tether->path_m > 0)) return std::nullopt;
      return s.tether->angle_sum / s.tether->path_m;
    }};

}  // namespace oxturn
