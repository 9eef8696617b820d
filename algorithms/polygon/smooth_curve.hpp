/// Curves made of many short segments: fewer vertices, and arcs in place of corners.
///
///   curve = rounded_corners(with_fewer_vertices(curve, 0.002, connector), {.off = 0.008, .chord = 0.0004}, connector);
///
/// O(n), and a segment test for each new segment: what would leave configuration space stays as it is.
#pragma once

#include "algorithms/transit/connector.hpp"

namespace oxturn {

/// Vertices are left out as long as all of them stay within `tolerance` metres of the segment that replaces them.
Polyline with_fewer_vertices(Polyline curve, double tolerance, const Connector& connector);

/// Vertices in the middle of straight lines are left out (exactly straight but for rounding).
Polyline without_collinear_vertices(const Polyline& curve);

struct Rounding {
  double off;    // metres at most from a corner to the chords that replace it
  double chord;  // metres at most from chords to the small arc that they stand for
};

/// Corners become chords along an arc that begins and ends on the corner's segments. They turn by equal angles of at
/// most 0.15 rad, or 0.3 rad where chords are still within `chord` of the arc; vertices that turn by less stay. A
/// corner takes no more than half of a segment.
Polyline rounded_corners(const Polyline& curve, const Rounding& rounding, const Connector& connector);

}  // namespace oxturn
