/// The parts of a region that zigzag fills one by one.
///
///   std::vector<Part> parts = cut_into_parts(region, Partition::trapezoid, lane_degrees);
///   parts = with_slivers_merged(std::move(parts), tool_width);
#pragma once

#include <vector>

#include "algorithms/lanes/lanes.hpp"
#include "geometry/region.hpp"

namespace oxturn {

/// One or more rings that are filled together.
struct Part {
  std::vector<Ring> rings;
  double area = 0;  // square metres
};

/// automatic: convex up to 150 vertices if CGAL finds such a partition, else approximate; convex: the fewest convex
/// parts; approximate: at most four times as many; none: one part with all rings. The others: see partition.hpp.
enum class Partition { automatic, convex, approximate, monotone, trapezoid, none };

/// Every ring as a polygon of its own.
Region as_region(const std::vector<Part>& parts);

/// `degrees`: the direction of the parallel sides of trapezoids, counter-clockwise from +x; of no use to other parts.
/// Throws std::invalid_argument for `convex` above 150 vertices; the message names `approximate`.
std::vector<Part> cut_into_parts(const Region& region, Partition partition, double degrees);

// A sliver is a part that is not worth a visit of its own: its area is below w^2 / 4, or its mean width (area over half
// the boundary) below w / 4, for a tool of width w.

/// Each sliver joins the part with which it shares the most boundary. O(n) for n edges in ordinary partitions.
std::vector<Part> with_slivers_merged(std::vector<Part> parts, double width);
/// Slivers are dropped.
std::vector<Part> without_slivers(std::vector<Part> parts, double width);

/// The part's bounding box in the frame.
Box box_in(const LaneFrame& frame, const Part& part);
/// Of the directions of the region's edges (lane_direction.hpp) the one, in degrees, across which the parts' widths add
/// up to least.
double least_sum_of_widths(const Region& region, const std::vector<Part>& parts);

}  // namespace oxturn
