// Smallest distance from the centre line to the boundary of configuration space: distance to the walls less the
// robot's radius, or distance from a polygonal footprint to the walls. Measured against the map itself, not the eroded
// space. Negative when outside: by how much the radius, or the footprint's nearest side, would have to be less.
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kClearanceM;

const Metric kClearanceM{"clearance_m", "m", Better::higher,
                         "least distance to configuration space's boundary, negative outside",
                         [](const Scored& s) -> std::optional<double> { return s.clearance; }};

}  // namespace oxturn
