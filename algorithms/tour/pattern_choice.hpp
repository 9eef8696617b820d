/// The best patterns for a given order.
///
///   tour = best_patterns(problem, tour);          // never dearer; begins with element 0
///
/// Shortest paths through layers, one for each element, its nodes the patterns: cluster optimisation (Fischetti,
/// Salazar Gonzalez and Toth 1997). O(p q) costs for neighbouring elements of p and q patterns.
#pragma once

#include "algorithms/tour/tour_problem.hpp"

namespace oxturn {

/// A path from each pattern of element 0, round the tour.
Tour best_patterns(const TourProblem& problem, const Tour& tour);

/// The best patterns of a run of elements between the patterns `from` and `to`; their cost with all connections.
double best_patterns_between(const TourProblem& problem, PatternId from, std::span<const ElementId> run, PatternId to,
                             std::vector<PatternId>& chosen);

}  // namespace oxturn
