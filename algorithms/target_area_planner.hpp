/// Teaches a planner to cover a target area that is only a part of the map.
///
///   planners.add(target_area_planner(my_planner()));
///
/// On a problem without a target area the planner runs as always. With one it is run in each connected component of
/// where it should work (Problem::work_space), as if that were configuration space; between the components, and
/// wherever a path has the tool off, the robot takes the shortest path through all of configuration space. What then
/// remains uncovered of the target is added as detours if the planner promises the whole target (lanes/repair.hpp).
///
/// A planner that promises the whole target gets the parameter `laps`: with `inner` it works in the same way where the
/// tool is wider than the robot, so that laps use all of the tool (lanes/inner_space.hpp).
///
/// All offline planners of the zoo are wrapped in this way. Those that see by lidar or are made for a tether cover the
/// whole map, and so the target too; `leashed` runs a wrapped planner in each component of the cut space.
#pragma once

#include "algorithms/coverage_planner.hpp"

namespace oxturn {

PlannerInfo target_area_planner(PlannerInfo info);

}  // namespace oxturn
