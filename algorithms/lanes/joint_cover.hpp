/// Whether a tool that works along some segments certainly covers all that lies inside a ring.
///
///   if (cover_inside(segments_of_lanes, tool_width / 2, piece.outer)) ...   // no overlay needed
///
/// Method      What segments that all pass a point within the radius cover is star-shaped seen from there, so it has no
///             holes: if the ring lies in it, all inside the ring does. A ring for which the middle of its box will not
///             do is halved by a chord. Whatever is inside lies inside one of the halves, even where the chord leaves
///             the ring: its winding numbers about a point add up to the ring's.
/// Guarantee   never true where something inside is farther than `radius` from all segments; often, but not always true
///             otherwise: never with more than 64 segments, or 256 vertices where edges are cut to the radius
/// Complexity  O(n s + n^2) for n vertices of the ring, its edges cut to the radius, and s segments
#pragma once

#include <span>

#include "algorithms/lanes/lanes.hpp"
#include "geometry/region.hpp"

namespace oxturn {

/// `segments` may be points; `ring` has at least one vertex, and edges may cross. `radius` in metres, > 0.
bool cover_inside(std::span<const Segment> segments, double radius, const Ring& ring);

}  // namespace oxturn
