/// Which parts of a path a tethered robot drives backwards, so that its heading suits the tether without a detour.
///
///   path = with_gears(problem, std::move(path), {.side = TetherSide::left, .least_angle = 0.8});
///
///     pull <-----. tether         Towards the pull in reverse: the heading, away from the pull, keeps any angle below
///                 \              90 degrees from it. Across the pull in reverse: the tether changes sides.
///          <======[R=
///     motion       heading
#pragma once

#include "algorithms/coverage_planner.hpp"

namespace oxturn {

enum class TetherSide { any, left, right };  // of the robot

struct GearRules {
  TetherSide side = TetherSide::any;  // on which the tether is to be wherever it does not run ahead or behind
  double least_angle = 0;             // between heading and pull, radians, below pi / 2; decides where both cannot be
};

/// The same path with gears: positions, lengths and the tool stay. The tether is followed as it is driven, so the rules
/// hold everywhere, transit included. The gear changes only where a rule demands it. O(n), beside the cost of
/// TautTether.
Path with_gears(const Problem& problem, const Path& path, const GearRules& rules);

/// The planner with the further parameter `reverse`: it then plans without regard to its parameters `winding` (of the
/// choices any, left, right) and `min_tether_angle`, and with_gears() fulfils them.
PlannerInfo with_reverse(PlannerInfo planner);

}  // namespace oxturn
