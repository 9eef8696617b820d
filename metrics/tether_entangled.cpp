// 1 if the tether ends longer than necessary, else 0:
//   length at the end > geodesic distance of the end (1 + 1e-6) + tolerance of the problem
// Empty as tether_max_m, and if the end is not connected to the anchor.
#include <cmath>

#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kTetherEntangled;

const Metric kTetherEntangled{
    "tether_entangled", "count", Better::lower,
    "1 if the tether ends longer than the geodesic to the path's end, else 0; empty as tether_max_m",
    [](const Scored& s) -> std::optional<double> {
      if (!s.tether || !std::isfinite(s.tether->geodesic_m)) return std::nullopt;
      const double shortest = s.tether->geodesic_m;
      const double slack = 1e-6 * shortest + s.tolerance;
      return s.tether->end_m > shortest + slack ? 1 : 0;
    }};

}  // namespace oxturn
