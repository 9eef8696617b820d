/// Lines that come in pieces, made whole.
///
///   const std::vector<Polyline> cut = joined_lines(field.cut_locus(error), error);
///
/// A shape that is computed piece by piece, as a cut locus triangle by triangle, has joints where it does not bend or
/// only a little. Whole lines have their vertices where the shape needs them.
#pragma once

#include <vector>

#include "geometry/point.hpp"

namespace oxturn {

/// Joins lines end to end where two meet and no others, leaves out vertices that the result misses by at most
/// `tolerance` metres (above 0), and pieces that repeat another or are shorter than it. Ends within `tolerance` of one
/// another meet: they are moved to one point, which is exactly the same in all lines that end there. Lines that close
/// a ring begin and end at one of its joints. The order does not depend on the lines' directions. Connected lines stay
/// connected. O(n log n).
std::vector<Polyline> joined_lines(std::vector<Polyline> lines, double tolerance);

/// The points at which at least `least` of the lines end, sorted; ends are the same only if they are equal.
std::vector<Point> common_ends(const std::vector<Polyline>& lines, std::size_t least);

}  // namespace oxturn
