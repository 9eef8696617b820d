// The parts that zigzag fills one by one.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "geometry/region.hpp"

namespace oxturn {

/// One or more rings that are filled together.
struct Part {
  std::vector<Ring> rings;
  double area = 0;
};

/// Cuts `region` by `partition`: convex (least number; throws std::invalid_argument above 150 corners, naming
/// `approximate`), approximate, monotone, trapezoid, none (one part, all rings), auto (convex up to 150 corners,
/// else approximate).
std::vector<Part> cut_into_parts(const Region& region, const std::string& partition);

/// A part smaller than w^2 / 4, or whose mean width is below w / 4 (area over half the boundary), is not worth a
/// visit of its own. merge: it joins the part with which it shares most boundary. Else it is dropped.
/// O(n) for n edges in ordinary partitions.
std::vector<Part> without_slivers(std::vector<Part> parts, double width, bool merge);

}  // namespace oxturn
