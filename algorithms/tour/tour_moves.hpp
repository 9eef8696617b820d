/// The moves of the local search. Each makes the tour cheaper at element a, if it can, and says so.
///
///   while (three_opt(search, a, false) || three_opt(search, a, true)) {}
///
/// A move is looked at only if it adds a connection from the neighbour list of a that is cheaper than one that it
/// removes there, and so on from end to end (the gain criterion of Lin and Kernighan 1973). O(k^2) connections each,
/// for k neighbours, and what the change of the array costs (tour_state.hpp).
#pragma once

#include "algorithms/tour/move_search.hpp"

namespace oxturn {

/// All exchanges of two or three connections that follow from one another (2-opt, Croes 1958; 3-opt, Lin 1965), among
/// them the insertion of a run of elements elsewhere (Or 1976), driven forwards or backwards. Symmetric problems.
bool three_opt(MoveSearch& search, ElementId a, bool backwards);
/// Exchanges two neighbouring runs of any length, without reversing them: the 3-opt move for asymmetric problems
/// (Or-3opt; Kanellakis and Papadimitriou 1980).
///
///   a -> [b ... c] -> [d ... e] -> f     becomes     a -> [d ... e] -> [b ... c] -> f
bool or_three_opt(MoveSearch& search, ElementId a);
/// Moves one element to behind a, in the pattern that is cheapest there.
bool reinsert(MoveSearch& search, ElementId a);
/// Drives element a in a better pattern, where it is.
bool change_pattern(MoveSearch& search, ElementId a);

}  // namespace oxturn
