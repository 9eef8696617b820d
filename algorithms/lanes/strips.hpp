// Strips: runs of lanes that are driven back and forth without a break, and the path through many of them.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/tour/open_tour.hpp"
#include "algorithms/transit/connector.hpp"

namespace oxturn {

struct LaneEnds {
  Point low, high;
  Polyline curve = {};  // from low to high, both included; empty: straight
};

/// Lanes in driving order. The two ways to begin (`up` on the first lane or not) both go on with the nearer end
/// of the next lane; each can be driven backwards too, so a strip has four patterns.
struct Strip {
  std::vector<LaneEnds> lanes;
  /// Optional: how the boundary runs from lane i to lane i + 1, at the low ends and at the high ends, ends
  /// included. Empty: straight, or round what is in the way.
  std::vector<Polyline> low_links, high_links;
  std::vector<std::size_t> neighbours;  // strips that border on it, for depth-first order

  /// Directions of the lanes if the first is driven up (or down).
  std::vector<bool> directions(bool first_up) const;
  TourElement patterns() const;
};

/// Order: "dfs", "nearest" or "improved"; "given": the strips one after the other as they stand. Drives all strips from the problem's start; links within a strip have the
/// tool on if they are at most 3 tool widths long, all else between lanes is transit.
/// Traces "lanes".
Path drive_strips(const Problem& problem, const std::vector<Strip>& strips, const std::string& order,
                  const Connector& connector, Context& context);

}  // namespace oxturn
