/// The parameter `sensing`: the planner knows the map beforehand, or sees it by lidar.
///
///   PlannerInfo berg() { return with_sensing(describe<Berg, Params>({...})); }
///
/// For planners that need a map: with sensing = lidar they plan on what survey_then_plan.hpp has explored.
#pragma once

#include "algorithms/coverage_planner.hpp"

namespace oxturn {

/// The planner with the further parameter sensing = map | lidar and the capability `online`. By lidar it never gets the
/// true problem.
PlannerInfo with_sensing(PlannerInfo planner);

}  // namespace oxturn
