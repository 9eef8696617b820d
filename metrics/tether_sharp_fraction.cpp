// Share of the path's length on which the angle between heading and tether is above the tether's sharp_angle, 0 to 1.
// Exactly at the limit does not count. Empty as tether_angle_min_rad.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kTetherSharpFraction;

const Metric kTetherSharpFraction{
    "tether_sharp_fraction", "1", Better::lower,
    "share of the path with an angle above the tether's sharp_angle; empty as tether_max_m, or no length",
    [](const Scored& s) -> std::optional<double> {
      if (!s.tether || !(s.tether->path_m > 0)) return std::nullopt;
      return s.tether->sharp_m / s.tether->path_m;
    }};

}  // namespace oxturn
