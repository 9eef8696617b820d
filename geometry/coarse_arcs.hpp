/// Fewer vertices on arcs around obstacles.
///
///   const Region space = erode(free, radius, tool_width / 1000, Bound::inside);     // some 12 vertices a right angle
///   const Region laps = with_coarser_arcs(space, tool_width / 200, tool_width / 2);  // some 6
///
/// Of a run of reflex vertices, such as an erosion makes at an obstacle's corner, some edges are dropped and the others
/// extended until they meet. So free space only shrinks, exactly, and where it did its new boundary lies within
/// `tolerance` of the old one. Rings neither cross nor vanish; a ring that loses no edge stays as it is. O(n log n) for
/// usual data.
///
///          .--*--.                    .-------.
///        *'       '*                 /         \        the obstacle is below
///       /           \               /           \                                .
#pragma once

#include <limits>
#include <optional>

#include "geometry/region.hpp"

namespace oxturn {

/// With a finite `reach`, edges are dropped only where a disc of that radius that follows the new boundary covers
/// behind it what it covered along the old one, but for seams of 3e-5 of the reach: at a corner from which the boundary
/// keeps no greater distance than the reach, as each of its tangents leads past the corner itself.
/// A point of the region that is given as `kept` stays in it.
Region with_coarser_arcs(const Region& region, double tolerance, double reach = std::numeric_limits<double>::infinity(),
                         const std::optional<Point>& kept = {});

}  // namespace oxturn
