/// Tours to begin a search with, and the simple methods that others are compared with.
///
///   Tour tour = greedy_tour(problem, lists);
#pragma once

#include "algorithms/tour/neighbour_lists.hpp"

namespace oxturn {

/// From element 0 always to the cheapest pattern that may come next. O(patterns^2) costs. Throws std::invalid_argument
/// if the precedence of elements has a cycle.
Tour nearest_neighbour_tour(const TourProblem& problem);
/// The cheapest connections of the neighbour lists first, unless an end is taken or they close a cycle (Bentley 1992);
/// the paths so begun are joined, each to the nearest. 14 to 20 % above the optimum in the plane. O(n k log n), and
/// O(paths^2) costs. Not for problems with precedence.
Tour greedy_tour(const TourProblem& problem, const NeighbourLists& lists);
/// The cheapest successor for each element (the assignment problem), the cycles of which are joined by the cheapest
/// exchanges, largest first (Karp 1979). 5 % above the optimum of random asymmetric matrices. O(n^3), O(n^2) memory.
/// Only for elements of one pattern, without precedence.
Tour patched_assignment_tour(const TourProblem& problem);

}  // namespace oxturn
