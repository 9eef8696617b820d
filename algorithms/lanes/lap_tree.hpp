/// Laps connected to one path by a spanning tree of the lengths of their links: each lap is a closed detour of another
/// one, from the point where they are nearest.
///
///   const Path path = drive_lap_tree(problem, laps_of(problem, tool_width, context), connector, context);
///
/// O(m log m) for laps with m vertices in all, and what their links cost (outline.hpp).
#pragma once

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lanes/laps.hpp"
#include "algorithms/transit/connector.hpp"

namespace oxturn {

/// From the problem's start to the lap that is nearest to it, and along all of them.
Path drive_lap_tree(const Problem& problem, const Laps& laps, const Connector& connector, Context& context);

}  // namespace oxturn
