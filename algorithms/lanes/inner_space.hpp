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
/// The part of the target that a tool narrower by `margin` metres on each side can cover from the problem's
/// configuration space, with arcs cut off by at most `chord` tool widths. Without a margin that is all of the target,
/// unless the problem is limited, since `Problem::restricted` keeps the target. If the narrower tool covers what it
/// can, one of the full width covers all that it can: no point of that is farther from here than the margin.
Region reachable_target(const Problem& problem, double margin = 0, double chord = 1e-3);

}  // namespace oxturn
