/// Optimal tours of a dozen elements.
///
///   if (exact_tour_is_cheap(problem)) tour = exact_tour(problem);
///   const BoundedTour found = branch_and_bound_tour(problem, 1000000);      // found.proven: it is optimal
#pragma once

#include <cstdint>

#include "algorithms/tour/tour_problem.hpp"

namespace oxturn {

/// Dynamic programming over (set of elements visited, last pattern) (Held and Karp 1962), precedence included. For n
/// elements of p patterns 2^n n^2 p^2 costs and 2^n n p values. Throws std::invalid_argument above 20 elements, and for
/// precedence with a cycle.
Tour exact_tour(const TourProblem& problem);
/// At most about a second.
bool exact_tour_is_cheap(const TourProblem& problem);

struct BoundedTour {
  Tour tour;
  bool proven = false;  // no other tour is cheaper; else the search ended early
  std::uint64_t nodes = 0;
};
/// Depth-first branch and bound as in Vollprecht (2014): the nearest element next; a branch is left as soon as it costs
/// as much as the best tour so far. Ends after `most_nodes` elements have been appended. Costs must not be negative.
/// Its first tour is that of the nearest neighbour; the bound is so weak that 15 elements are many.
BoundedTour branch_and_bound_tour(const TourProblem& problem, std::uint64_t most_nodes);

}  // namespace oxturn
