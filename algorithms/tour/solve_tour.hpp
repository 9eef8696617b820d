/// The tour solver: a local search that is repeated from small random changes.
///
///   const Tour tour = solve_tour(problem, context);                     // default effort
///   const Tour best = solve_tour(problem, context, {.kicks = 1000000, .improved = show});
///
/// Symmetric problems by 3-opt moves, asymmetric ones by those that reverse nothing (tour_moves.hpp); over neighbour
/// lists, with don't-look bits; started from a greedy tour (asymmetric also from a patched assignment); patterns by
/// dynamic programming along the order, in turn with moves (generalised tours). Iterated: kick, search, keep what is
/// cheaper or, less and less often, a little dearer, else undo (Martin, Otto and Felten 1991). Small problems are
/// solved exactly (exact_tour.hpp).
/// A descent costs O(n log n), 0.1 s for 16 000 points; a kick 15 us in the plane, 90 us for random matrices of 1000
/// elements. Memory O(k n). The same effort gives the same tour on every machine; the context's deadline only ends it
/// early, with the best tour so far. Tours of 1000 points are 1 % above the Held-Karp bound after 10^5 kicks. Where
/// points lie in clusters far apart, the order of the clusters may stay some per cent too long.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "algorithms/context.hpp"
#include "algorithms/tour/tour_problem.hpp"

namespace oxturn {

struct TourEffort {
  std::optional<std::uint64_t> kicks = {};  // none given: the larger of 20 for each element and 20000
  bool until_deadline = false;              // instead of kicks: all the time the context has; differs from run to run
  std::size_t neighbours = 8;               // in lists; asymmetric problems take two more
  bool exact_if_small = true;               // dynamic programming where it is cheap
  std::function<void(const Tour&)> improved = {};  // called with better tours, at most once in 100 kicks
  std::function<bool()> enough = {};  // ends the search early, with the best tour so far; asked after each kick

  std::uint64_t kicks_for(std::size_t elements) const;
};

/// Begins with element 0. Throws std::invalid_argument for precedence with a cycle, Infeasible if no tour without
/// forbidden connections was found.
Tour solve_tour(const TourProblem& problem, Context& context, const TourEffort& effort = {});
/// The same from a given tour that keeps precedence and begins with element 0. Never dearer; always by local search.
Tour improved_tour(const TourProblem& problem, const Tour& tour, Context& context, const TourEffort& effort = {});

}  // namespace oxturn
