// Minkowski sum and difference of a region with a disc. Round arcs become chords; the side on which the chord
// error falls is chosen, so that the answer is a certain inside or outside bound.
#pragma once

#include "geometry/region.hpp"

namespace oxturn {

enum class Bound {
  inside,   // result is a subset of the true set
  outside,  // result is a superset of the true set
};

/// region (+) disc(radius): all points within `radius` of it. Chord error at most `chord_error` (> 0). O(n log n) for
/// usual data, also over the fine arcs that an erosion left: 10^6 corners in about a second (offset.cpp, dent.hpp).
Region dilate(const Region& region, double radius, double chord_error, Bound bound);

/// region (-) disc(radius): all points whose distance to the complement is at least `radius`. With
/// Bound::inside every point of the result keeps at least `radius` (snapping included), so a passage not wider
/// than 2 * (radius + chord_error) may close. Large inputs are the rule: 20 000 corners with 800 holes in well
/// under a second.
Region erode(const Region& region, double radius, double chord_error, Bound bound);

}  // namespace oxturn
