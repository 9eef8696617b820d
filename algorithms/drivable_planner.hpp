/// Gives a planner the capability `curvature`: for a robot with a least turning radius its path is made drivable.
///
///   planners.add(drivable_planner(my_planner()));
///
/// The planner is given the same problem with a robot that turns on the spot; its path then goes through drivable()
/// (smoothing/drivable.hpp). Other robots get the planner's own path. All offline planners of the zoo that are not
/// made for a tether are wrapped in this way.
#pragma once

#include "algorithms/coverage_planner.hpp"

namespace oxturn {

PlannerInfo drivable_planner(PlannerInfo info);

}  // namespace oxturn
