// Which parts of the boundary of the cut space must be driven, so that laps may do the rest.
#pragma once

#include <vector>

#include "algorithms/transit/tether_space.hpp"

namespace oxturn {

struct NeededBoundary {
  /// All parts of the cut space together.
  Region space;
  /// Laps need not care for what is nearer than half a tool width to the boundary of this.
  Region inner;
  /// What must be driven: closed rings (as regions of one polygon each), and open stretches between two places where the
  /// cut meets a wall. All lie in `space`.
  Region rings;
  std::vector<Polyline> chains;
};

/// `open`: where the cut runs nearly along the string (within 25 degrees), laps end at it and cover both sides of it, so
/// it is not driven; what is left of a ring is then open. Otherwise all rings are closed.
NeededBoundary needed_boundary(const TetherSpace& leash, bool open);

}  // namespace oxturn
