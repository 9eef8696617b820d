// The online form of any planner: explore what can be reached, plan on what is believed, drive that, and go on until
// nothing that has come to be known since is left bare.
//
// With a tether the robot goes home along its string in between, so that the planner finds the string along the
// geodesic. Where the belief stops a planned path, the part that is still free is kept, joined by shortest paths. What
// turns out to be free only while sweeping is covered at the end: nearest bare place first.
#pragma once

#include <functional>

#include "algorithms/online/driver.hpp"

namespace oxturn {

/// Plans on a problem that is believed. What `plan` throws, this throws.
using OfflinePlan = std::function<Path(const Problem& believed, Context& context)>;

/// For a planner's `sensing = lidar`. Throws Unsupported for a robot without a lidar.
Path plan_online(const Problem& truth, Context& context, const OfflinePlan& plan, const OnlineSettings& settings = {});

}  // namespace oxturn
