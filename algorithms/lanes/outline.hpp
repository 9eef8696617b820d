// Driving every wall once, tool on: rings spliced into a path that is already there.
//
// Each boundary ring of configuration space becomes a loop that leaves the path where it comes nearest to the ring
// and returns there. Rings far from the path hang on other rings, the nearest first (Prim), so rings alone cover
// regions of corridors. A detour at most `width` long is driven with the tool on, a longer one is transit.
#pragma once

#include "algorithms/coverage_planner.hpp"
#include "algorithms/transit/connector.hpp"

namespace oxturn {

/// About O(n) for n segments when rings and path pass within a few widths of each other everywhere; each doubling
/// of the distance to the farthest ring costs another pass.
Path with_outline(const Problem& problem, const Path& path, double width, const Connector& connector, Context& context);
/// The same with the rings of `rings`, which lie in configuration space, in place of its own.
Path with_rings(const Problem& problem, const Region& rings, const Path& path, double width, const Connector& connector,
                Context& context);

}  // namespace oxturn
