/// The part of the boundary of the cut space that must be driven, so that level sets can cover the rest.
///
///   const NeededBoundary boundary = needed_boundary(space, CutEdges::across_tether);
///   level_sets(space, boundary.space, boundary.inner, ...);
#pragma once

#include <vector>

#include "algorithms/transit/tether_space.hpp"

namespace oxturn {

struct NeededBoundary {
  /// All components of the cut space together.
  Region space;
  /// Level sets may leave out what is nearer than half a tool width to the boundary of this region.
  Region inner;
  /// To be driven, within `space`: closed rings (each a polygon of its own), and open chains, which end where the cut
  /// meets a wall or at the turning points of the distance from the anchor.
  Region rings;
  std::vector<Polyline> chains;
  /// To be covered besides: what lies between passes along the cut and walls, farther than half a tool width from both.
  Region pockets;
};

/// Which parts of the cut's two sides are driven: all of them, so that every ring is closed; or only where the cut runs
/// across the tether. Where it runs nearly along the tether (within 25 degrees), level sets end at it from both sides
/// and cover it; rings are then open there.
enum class CutEdges { all, across_tether };

NeededBoundary needed_boundary(const TetherSpace& space, CutEdges edges);

}  // namespace oxturn
