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

/// Pushes the ends of what has changed; the cost is added to what the search has gained. Returns an element in the
/// middle; nullopt, and nothing done, if the order of elements forbids the kick, or there are less than 4. O(length of
/// blocks).
std::optional<ElementId> kick(MoveSearch& search, Rng& rng);

}  // namespace oxturn
