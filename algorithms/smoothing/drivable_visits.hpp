/// Covers what a drivable path leaves uncovered, as far as the robot can get there and away again.
///
///   driven = with_visits(problem, std::move(driven), left_out, {.allowed = 0.5}, space, context);
///
/// Links that cover something are driven with the tool on, and strokes that were left out are inserted where that costs
/// least (reinserted_strokes.hpp). Then uncovered pieces are visited by short strokes (covering_strokes.hpp): a greedy
/// cover, always the stroke next that covers most for each metre that the path becomes longer. The path so far is where
/// others may be inserted, so visits near each other follow each other. What is uncovered is found exactly before each
/// of some rounds, until no more than is allowed is left, or no visit is worth its metres. At last, strokes are taken
/// out whose area the others cover (needless_strokes.hpp).
///
/// Guarantee   the path stays drivable
/// Complexity  in each of at most six rounds, some steps of O(m log m) for a path of m segments, and for each stroke
///             tried some hundred candidates. Strokes tried: four that fail for each uncovered piece, those that
///             succeed, and those near one that succeeded once more
#pragma once

#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/smoothing/linked_strokes.hpp"
#include "maps/problem.hpp"

namespace oxturn {

struct VisitLimits {
  double allowed = 0;         // square metres that may stay uncovered: no more visits then
  double least_gain = 0.001;  // share of the tool's width that a visit covers for each metre that it adds, at least
};

/// `left_out`: strokes worth driving whole. Publishes better paths. Ends early if cancelled.
std::vector<LinkedStroke> with_visits(const Problem& problem, std::vector<LinkedStroke> driven,
                                      const std::vector<Polyline>& left_out, const VisitLimits& limits,
                                      const CarSpace& space, Context& context);

}  // namespace oxturn
