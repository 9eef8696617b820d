/// Where a robot drives its laps and lanes if the tool reaches farther than the robot may drive, or only a part of the
/// map is to be covered: the points of configuration space about w/2 or more from the boundary of the target.
///
///   const Region inner = inner_space(problem);            // components below a quarter of w^2 are dropped
///   path = repaired(problem, plan_in(inner), connector, context);
///
///        wall ________                  The lap runs at w/2 from the wall, so that all of the tool is in use. What
///            |########   # target       remains in the corners takes short detours.
///            |#  .----   . lap
///            |#  |
///
/// Without a target area, and if the tool is no wider than the robot, that is configuration space but for rounding.
/// O(n log n) for n vertices of the target.
#pragma once

#include "maps/problem.hpp"

namespace oxturn {

Region inner_space(const Problem& problem);
/// The part of the target that can be covered from the problem's configuration space: all of it, unless that is
/// limited, since `Problem::restricted` keeps the target.
Region reachable_target(const Problem& problem);

}  // namespace oxturn
