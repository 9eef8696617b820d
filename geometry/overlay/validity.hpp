// Is this a region, and if not, why and where?
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "geometry/region.hpp"

namespace oxturn {

struct Flaw {
  std::string reason;  // "edges cross", "ring has fewer than 3 corners", ...
  Point point;
};

/// The first flaw that cannot be repaired without guessing: a coordinate that is not finite, a ring with fewer
/// than three different corners or no area, edges that cross (of one ring or of two), a hole outside its
/// polygon. O(n log n) for usual data, by an index. Touching rings, spikes, duplicate and collinear points,
/// wrong orientation are no flaws: `repaired` mends them.
std::optional<Flaw> find_flaw(const Region& region);

/// The same point set in canonical shape: duplicate points, spikes and exactly collinear corners removed, rings
/// oriented, touching or overlapping holes united, holes that touch the border cut out, sliver polygons with no
/// area dropped. Throws std::invalid_argument "<reason> at (x, y)" for what find_flaw finds.
Region repaired(const Region& region);

}  // namespace oxturn
