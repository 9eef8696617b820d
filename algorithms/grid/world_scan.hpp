/// MyCarbot's scan of an unknown world: the robot heads for a point outside the world until no path leads there any
/// more.
///
///   scan_world(robot, context);
///
/// Source      MyCarbot (TH Nuernberg), section 2.1
/// Guarantee   Unknown space counts as free, and each stop shows more of the outer wall. When no path is left, the
///             outer wall is known except for gaps that the robot does not fit through.
/// Complexity  a motion O(cells of the belief's window at its coarsest level, radius / 2)
/// Decisions   1. The point lies far up (the source's pictures end at the upper wall). Any path out of the window of
///                what has been seen counts; the one nearest to that point by steps is taken.
///             2. Where the robot cannot go on although nothing is known to be in the way, the point half a radius
///                ahead is taken as wall from then on, so that the scan ends.
#pragma once

#include "algorithms/online/driver.hpp"

namespace oxturn {

/// Drives until the outer wall is closed or the run is cancelled.
void scan_world(OnlineRobot& robot, const Context& context);

}  // namespace oxturn
