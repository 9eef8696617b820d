/// The best patterns for a given order.
///
///   tour = best_patterns(problem, tour);          // never dearer; begins with element 0
#pragma once

#include "algorithms/tour/tour_problem.hpp"

namespace oxturn {

/// A shortest path through layers, one for each element, its nodes the patterns: cluster optimisation (Fischetti,
/// Salazar Gonzalez and Toth 1997), searched from each pattern of element 0. O(p^2) costs for an element of p patterns,
/// times the patterns of element 0.
Tour best_patterns(const TourProblem& problem, const Tour& tour);

}  // namespace oxturn
