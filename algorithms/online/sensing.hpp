// The parameter `sensing`: a planner that knows the map beforehand, or one that sees it by lidar.
#pragma once

#include "algorithms/coverage_planner.hpp"

namespace oxturn {

/// The planner with one parameter more, sensing = map | lidar, and the capability `online`. With lidar it never sees the
/// true problem: survey_then_plan.hpp hands it what is believed.
PlannerInfo with_sensing(PlannerInfo planner);

}  // namespace oxturn
