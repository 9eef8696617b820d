/// A lower bound of the length of a path by some points that it must cover one after the other: for small targets.
///
///   const double metres = tour_bound(problem.target(), tool_width, uncovered_m2, problem.start());
///
/// Let p_1, ..., p_n be points of the target, the witnesses, and r = w/2. A path that leaves no more than the area u
/// uncovered comes within r + e_k of p_k, if e_k is so large that more than u of the target lies within e_k of p_k. In
/// the order in which it first does so, it drives from one to the next at least |p_i - p_j| - 2 r - e_i - e_j, and
/// before the first one |s - p_i| - r - e_i from the start s. So no path is shorter than the shortest Hamiltonian path
/// from s through all witnesses with these costs, or 0 where they are negative. That is bounded from below by spanning
/// trees: with any weights of the nodes added to the costs of their edges, all Hamiltonian paths change alike but for
/// their ends, and none costs less than the cheapest tree. Weights are found by subgradient ascent.
///
/// Some milliseconds. 0 for targets of more than 60 tool squares, where area is the better bound.
/// Source      Held and Karp, "The traveling-salesman problem and minimum spanning trees", 1970
#pragma once

#include "geometry/region.hpp"

namespace oxturn {

/// Metres, at least 0. `width`: the tool's. `uncovered_m2`: of the target at most.
double tour_bound(const Region& target, double width, double uncovered_m2, const Point& start);

}  // namespace oxturn
