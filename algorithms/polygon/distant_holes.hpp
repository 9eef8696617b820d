/// Holes that an overlay need not see, because they lie far from where it changes anything.
///
///   auto [near, far] = without_holes_off(box, polygon);
///   Region rest = subtract({{near}}, what_lies_in_the_box);
///   if (!put_back(far, rest)) rest = subtract({{polygon}}, what_lies_in_the_box);
///
/// O(n) for n vertices, and a search for each hole if the region has several polygons.
#pragma once

#include <utility>
#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

/// The polygon without the holes that lie outside of a box, and these.
std::pair<Polygon, std::vector<Ring>> without_holes_off(const Box& box, const Polygon& polygon);
/// Each hole to the polygon that it lies in. False if there is none, because a ring that came nearer crosses it: then
/// the region is incomplete.
bool put_back(const std::vector<Ring>& holes, Region& region);

}  // namespace oxturn
