// Smallest distance from the centre line to the boundary of configuration space: distance to the walls less the
// robot's radius. Measured against the map itself, not the eroded space. Negative when outside.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kClearanceM;

const Metric kClearanceM{"clearance_m", "m", Better::higher,
                         "least distance to configuration space's boundary, negative outside",
                         [](const Scored& s) -> std::optional<double> { return s.clearance; }};

}  // namespace oxturn
