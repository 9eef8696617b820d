/// Strips: consecutive lanes that are driven back and forth without a break, and the path through many strips.
///
///   std::vector<Strip> strips{{.lanes = {{{0, 0}, {0, 5}}, {{1, 0}, {1, 5}}}}};
///   const Path path = drive_strips(problem, strips, StripOrder::improved, connector, context);
///
///        high      .---.   .---.
///                  |   |   |   |        one strip of four lanes, its first lane driven up
///        low       ^   '---'   v
#pragma once

#include <array>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/tour/open_tour.hpp"
#include "algorithms/transit/connector.hpp"

namespace oxturn {

struct LaneEnds {
  Point low, high;
  Polyline curve = {};  // from low to high, both included; empty: straight
};

/// Lanes in driving order. The first lane is driven up (low to high) or down; the others so that the straight links
/// between them have the least total length. The result can also be driven backwards, so a strip has four patterns.
struct Strip {
  std::vector<LaneEnds> lanes;
  /// Optional: the boundary from lane i to lane i + 1 along the low ends and along the high ends, ends included. Lanes
  /// then alternate strictly. Empty: links are straight or shortest paths.
  std::vector<Polyline> low_links = {}, high_links = {};
  std::vector<std::size_t> neighbours = {};  // adjacent strips, for the depth-first order
  bool work_links = true;                    // short links between lanes are driven with the tool on

  /// For each lane whether it is driven up, if the first one is driven up or not.
  std::vector<bool> directions(bool first_up) const;
  /// In the order of kStripPatterns; a single lane has only the first two.
  TourElement patterns() const;
};

/// Makes two different strips neighbours.
void connect(std::vector<Strip>& strips, std::size_t a, std::size_t b);

/// How a strip is driven.
struct StripPattern {
  bool first_up;   // the first lane is driven from low to high
  bool backwards;  // the whole strip from its end to its beginning
};
inline constexpr std::array<StripPattern, 4> kStripPatterns{
    {{true, false}, {true, true}, {false, false}, {false, true}}};

/// improved: nearest neighbour, then local search, but the best of all orders for up to eight strips; depth_first: on
/// the graph of neighbours; given: as listed; generalised: by the tour solver (tour/generalised_tour.hpp).
enum class StripOrder { improved, nearest, depth_first, given, generalised };

/// Drives all strips from the problem's start. Within a strip, links up to 3 tool widths long have the tool on; longer
/// ones and the paths between strips are transit. Traces "lanes". Ends early if cancelled. Cost: see open_tour.hpp.
Path drive_strips(const Problem& problem, const std::vector<Strip>& strips, StripOrder order,
                  const Connector& connector, Context& context);
/// The same from another point of configuration space.
Path drive_strips(const Problem& problem, const Point& from, const std::vector<Strip>& strips, StripOrder order,
                  const Connector& connector, Context& context);

}  // namespace oxturn
