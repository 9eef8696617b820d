/// A lower bound of every tour's cost, by which tours of any size can be judged.
///
///   const double bound = held_karp_bound(problem, problem.cost(tour));
///   gap = problem.cost(tour) / bound - 1;
#pragma once

#include "algorithms/tour/tour_problem.hpp"

namespace oxturn {

/// The 1-tree bound of Held and Karp (1970): a spanning tree and one more edge cost no more than a tour, also after
/// prices of elements have been added that every tour pays alike. The prices climb by subgradients (Held, Wolfe and
/// Crowder 1974). About 0.7 % below the optimum in the plane.
/// Asymmetric problems: each element has a price for leaving and one for entering, an edge costs the cheaper of its two
/// directions; this is the symmetric form on 2n cities (Jonker and Volgenant 1983) with its fixed edges contracted.
/// Prices start from the dual solution of the assignment problem, so the bound is never below that of the assignment.
/// Elements with several patterns: the least over pairs of patterns; precedence is ignored. Both keep it a bound.
/// `tour_cost`: of any tour; it sets the length of the steps. Ascends on a sparse graph, but the bound is that of the
/// complete graph: some 500 sparse trees, O(n k log n) each, and a few complete ones, O(patterns^2) each. 0.5 s for
/// 1000 points. Costs must not be negative.
double held_karp_bound(const TourProblem& problem, double tour_cost);

}  // namespace oxturn
