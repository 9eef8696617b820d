/// Where an area is narrower than the narrowest pen: lines along its middle, to be drawn once.
///
///   for (const Polyline& line : thin_lines(area, 0.04, 0.2)) draw(line, 0.04);
///
///      .------------.  thick parts are left to the fill;           .------------.
///      |            '--------------.                               |            '
///      |            .--------------'         becomes               |             --------------
///      '------------'                                              '------------'
///
/// The medial axis (geometry/mesh/medial_axis.hpp) where no disc as wide as the pen fits, without what leads into
/// corners: branches that reach no further than half as much again as the disc they begin in, or than the pen. At
/// junctions the straightest lines go on in one. A dot becomes a line as long as a quarter of the pen's width, unless
/// it is smaller.
/// Complexity  O(n log n) for n vertices
#pragma once

#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

/// `width` of the pen, metres. `least`: lines shorter than that, in metres, that lead from a thick part to a tip are
/// left out.
std::vector<Polyline> thin_lines(const Polygon& area, double width, double least);

}  // namespace oxturn
