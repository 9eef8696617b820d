/// The online form of any planner: explore what can be reached, plan on what is believed, drive that, and continue
/// until nothing that has become known since is uncovered.
///
///   return plan_online(problem, context, [&](const Problem& believed, Context& inner) {
///     return planner.plan(believed, inner);
///   });
///
/// With a tether the robot returns to its start along the tether in between, so that the plan begins with the tether
/// along the geodesic. Where the belief stops a planned path, the parts of the rest that are still free are kept and
/// connected by shortest paths. What turns out to be free only while the plan is driven is covered at the end, nearest
/// first.
#pragma once

#include <functional>

#include "algorithms/online/driver.hpp"

namespace oxturn {

/// Plans on the believed problem. Exceptions pass through.
using OfflinePlan = std::function<Path(const Problem& believed, Context& context)>;

/// Records `survey_m` (metres driven before the plan, with the return to the start) and `leftover_m` (after it). Throws
/// Unsupported for a robot without a lidar.
Path plan_online(const Problem& truth, Context& context, const OfflinePlan& plan);

/// The planner with the further parameter sensing = map | lidar and the capability `online`: by lidar it plans as
/// plan_online does and never gets the true problem.
///
///   PlannerInfo berg() { return with_sensing(describe<Params, plan>({...})); }
PlannerInfo with_sensing(PlannerInfo planner);

}  // namespace oxturn
