/// Covers what a drivable path leaves uncovered, as far as the robot can get there and away again.
///
///   driven = with_visits(problem, std::move(driven), left_out, allowed, space, context);
///
/// Links that cover something are driven with the tool on, and strokes that were left out are inserted where that costs
/// least (reinserted_strokes.hpp). Then uncovered pieces are visited, the largest first, by short strokes
/// (covering_strokes.hpp), inserted where it costs least for what they cover. What is uncovered is found exactly before
/// each of some rounds, until no more than is allowed is left, or a round finds no stroke that can be inserted.
///
/// Guarantee   the path stays drivable, and covers what it covered before
/// Complexity  in each of at most ten rounds O(m log m) for a path of m segments, and for each stroke tried some
///             hundred candidates. Strokes tried: four that fail for each uncovered piece, and those that succeed
#pragma once

#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/smoothing/linked_strokes.hpp"
#include "maps/problem.hpp"

namespace oxturn {

/// `left_out`: strokes worth driving whole. `allowed`: square metres that may stay uncovered. Publishes better paths.
/// Ends early if cancelled.
std::vector<LinkedStroke> with_visits(const Problem& problem, std::vector<LinkedStroke> driven,
                                      const std::vector<Polyline>& left_out, double allowed, const CarSpace& space,
                                      Context& context);

}  // namespace oxturn
