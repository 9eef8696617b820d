/// Where an area is narrower than the narrowest pen: lines along its middle, to be drawn once.
///
///   const ThinLines thin(area, 0.04);
///   for (const Polyline& line : thin.lines(0.2)) draw(line, 0.04);
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
/// Complexity  O(n log n) for n vertices; lines with another limit O(n)
#pragma once

#include <vector>

#include "geometry/mesh/medial_axis.hpp"
#include "geometry/region.hpp"

namespace oxturn {

class ThinLines {
 public:
  /// `width` of the pen, metres. Keeps a reference to the area.
  ThinLines(const Polygon& area, double width);
  /// `least`: lines shorter than that, in metres, that lead from a thick part to a tip are left out.
  std::vector<Polyline> lines(double least) const;
  /// Of the largest disc in the area, metres.
  double largest_radius() const;

 private:
  const Polygon& area_;
  double width_;
  MedialAxis axis_;
};

}  // namespace oxturn
