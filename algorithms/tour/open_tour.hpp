/// An open tour from a given start over elements, each of which can be driven in several patterns.
///
///   const TourCosts costs(start, elements, connector);
///   std::vector<TourStop> tour = nearest_tour(costs, problem, context);
///   improve_tour(costs, tour, context);
///
/// Nearest neighbour; Or-opt (Or 1976) and 2-opt (Croes 1958) over neighbour lists; the pattern of each element by
/// dynamic programming along the order, as is usual for generalised tours.
/// Costs are lengths of paths inside configuration space. Straight distance is their lower bound, which saves most of
/// the searches. Deterministic: the effort is limited by counts, never by the clock (a cancelled context ends it early,
/// with the tour as good as it is by then).
#pragma once

#include "algorithms/coverage_planner.hpp"
#include "algorithms/tour/tour_costs.hpp"

namespace oxturn {

/// Always to the nearest entry by path length, as a wave through the triangles of free space finds it
/// (transit/nearest_component.hpp). Each step costs what is nearer than the answer. `problem` is that of the connector.
std::vector<TourStop> nearest_tour(const TourCosts& costs, const Problem& problem, Context& context);
/// Depth-first over the graph `neighbours`: from an element to its nearest unvisited neighbour; if there is none, to
/// the nearest unvisited neighbour of the element visited last that still has one; else to the nearest element.
std::vector<TourStop> depth_first_tour(const TourCosts& costs, const Problem& problem,
                                       const std::vector<std::vector<std::size_t>>& neighbours, Context& context);
/// Or-opt and 2-opt moves until none helps or the effort is spent. Never longer than before. O(n log n), and some
/// hundred candidates for each stop in a round of moves.
void improve_tour(const TourCosts& costs, std::vector<TourStop>& tour, Context& context);
/// The best patterns for this order; where consecutive elements are far apart, by paths with the same bends. O(n p^2)
/// path lengths for p patterns an element.
void choose_patterns(const TourCosts& costs, std::vector<TourStop>& tour);

}  // namespace oxturn
