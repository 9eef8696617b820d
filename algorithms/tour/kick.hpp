/// A random change that the local search does not undo at once: the double bridge of Martin, Otto and Felten (1991), in
/// a small window of the tour.
///
///   P [B] [C] [D] S     becomes     P [D] [C] [B] S
///
/// All four connections change. (P [C] [B] [D] S, often called by the same name, changes three, and is undone by a
/// single move.) With blocks of up to 30 elements it is cheap, and what it disturbs stays near.
#pragma once

#include "algorithms/tour/move_search.hpp"
#include "base/random.hpp"

namespace oxturn {

/// Pushes the ends of what has changed; the cost is added to what the search has gained. False if the order of elements
/// forbids it. O(1) for at least 8 elements; with fewer nothing is done.
bool kick(MoveSearch& search, Rng& rng);

}  // namespace oxturn
