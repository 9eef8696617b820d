/// What a disc sweeps while its centre runs along lines.
///
///   const Region swept = swath({leg.points}, tool_width / 2, 1e-3 * tool_width, Bound::outside);
///   const Region missed = subtract(target, swath_parts(lines, tool_width / 2, 1e-3 * tool_width, Bound::outside));
///
/// The union of a rectangle about each segment, arcs on the outer side of bends, and half discs at the ends; arcs are
/// chords or tangents. Lines that lie many deep on each other cost their sum (boolean.hpp): O(m log m) for parts with m
/// vertices in all, which are few where a line bends gently. Where consecutive parts of lines lie several deep on each
/// other they are united first. Lines with vertices nearer together than the chord error are thinned (thinned.hpp)
/// within it.
#pragma once

#include "geometry/overlay/offset.hpp"

namespace oxturn {

/// `radius` and `chord_error` in metres, both positive. A line of one point gives a disc. Throws std::invalid_argument
/// for coordinates that are not finite.
Region swath(const std::vector<Polyline>& lines, double radius, double chord_error, Bound bound);
/// The same in parts that overlap, to be subtracted: their union is most of the work.
std::vector<Region> swath_parts(const std::vector<Polyline>& lines, double radius, double chord_error, Bound bound);
/// The same, but for the half discs at the ends of lines, of which three chords are left: half as many vertices where
/// lines are short.
std::vector<Region> swath_parts_with_blunt_ends(const std::vector<Polyline>& lines, double radius, double chord_error,
                                                Bound bound);

}  // namespace oxturn
