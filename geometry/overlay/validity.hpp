/// Validity of regions: the first flaw, and repair of what can be repaired without guessing.
///
///   if (const auto flaw = find_flaw(region)) std::cerr << flaw->reason << " at " << to_text(flaw->point);
///   const Region clean = repaired(region);      // throws if there is a flaw
#pragma once

#include <optional>
#include <string>

#include "geometry/region.hpp"

namespace oxturn {

struct Flaw {
  std::string reason;  // "edges cross", "ring has no area", ...
  Point point;
};

/// The first flaw that cannot be repaired without guessing: a coordinate that is not finite, a ring with fewer than
/// three different points or without area, edges that cross (of one ring or of two), a hole outside its polygon. Not
/// flaws, since repaired() removes them: touching rings, spikes, repeated and collinear points, wrong orientation. O(n
/// log n) for usual data.
std::optional<Flaw> find_flaw(const Region& region);

/// The same set of points in canonical form: repeated points, spikes and exactly collinear vertices removed, rings
/// oriented, touching or overlapping holes united, holes that touch the outer ring made part of it, polygons without
/// area dropped. Throws std::invalid_argument "REASON at (X, Y)" for what find_flaw() finds. O(n log n) for usual data.
Region repaired(const Region& region);

/// The ring without vertices at which it does not turn (exactly): repeated and collinear points, and spikes that run
/// back on themselves. Empty if fewer than three vertices are left. O(n).
Ring without_straight_vertices(const Ring& ring);

}  // namespace oxturn
