/// The moves of the local search. Each looks for a move that makes the tour cheaper at element a, makes it, and says so.
///
///   while (two_opt(search, a, false) || or_opt(search, a, false)) {}
///
/// A move is looked at only if it adds a connection from the neighbour list of a that is cheaper than one that it
/// removes there. O(k) connections each, for k neighbours, and what the change of the array costs (tour_state.hpp).
#pragma once

#include "algorithms/tour/move_search.hpp"

namespace oxturn {

/// Reverses a run of elements (Croes 1958). Symmetric problems.
///
///   a -> b ... c -> d     becomes     a -> c ... b -> d
bool two_opt(MoveSearch& search, ElementId a, bool backwards);
/// Moves up to three elements to between two others, in either direction (Or 1976); a single one in any pattern.
/// Symmetric problems in both directions, others forwards only and without reversing.
///
///   a -> b, p -> c..y -> n     becomes     a -> c..y -> b, p -> n
bool or_opt(MoveSearch& search, ElementId a, bool backwards);
/// Exchanges two neighbouring runs of any length, without reversing them: the 3-opt move for asymmetric problems
/// (Kanellakis and Papadimitriou 1980).
///
///   a -> [b ... c] -> [d ... e] -> f     becomes     a -> [d ... e] -> [b ... c] -> f
bool or_three_opt(MoveSearch& search, ElementId a);
/// Drives element a in a better pattern, where it is.
bool change_pattern(MoveSearch& search, ElementId a);

}  // namespace oxturn
