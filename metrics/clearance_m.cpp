// Least distance from the path to the boundary of configuration space, metres; negative outside of it:
//   disc         least distance from the path to a wall, less the radius
//   footprint    least distance from the footprint to a wall while it moves along the path
// Measured against the walls of the map, not against the eroded space. Outside, the value is minus the length by which
// the radius, or the distances of the footprint's sides from its centre, would have to be less (validity.cpp,
// footprint.hpp).
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kClearanceM;

const Metric kClearanceM{"clearance_m", "m", Better::higher,
                         "least distance to configuration space's boundary, negative outside",
                         [](const Scored& s) -> std::optional<double> { return s.clearance; }};

}  // namespace oxturn
