// Area of the target, square metres: what the robot's tool can cover of free space (Problem::target).
#include "metrics/score.hpp"

namespace oxturn {

extern const Metric kTargetM2;

const Metric kTargetM2{"target_m2", "m2", Better::neither, "area that can be covered",
                       [](const Scored& s) -> std::optional<double> { return area(s.problem.target()); }};

}  // namespace oxturn
