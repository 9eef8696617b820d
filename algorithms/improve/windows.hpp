/// Anneals a path, a large one window by window, so that a move costs as much on a large map as on a small one.
///
///   const Annealed now = annealed(problem, target, points, options, schedule, focus, threads, rng, context);
///
///    _____________        A window is a square of some tool widths. Only what the path does in it is changed: where
///   |  .--|--.    |       the path crosses its sides, vertices are fixed, and so is all of the path outside. Links
///   |  |  |  |    |       stand for the parts of the path between leaving the window and coming back, which may change
///   |__|__|__|____|       their order and direction: the whole stays one path.
///
/// In each pass every point of the target is in one window; the windows of the next pass lie elsewhere. The price of
/// uncovered area is the same in all windows of a pass, and so are the witnesses. A pass has four batches of windows:
/// of two rows and two columns side by side, every other one. Windows of a batch are changed at the same time, each
/// with random numbers of its own, and then put into the path in their order; changes that contradict those before
/// them (window_parts.hpp) are dropped.
///
/// Source      ours
/// Complexity  a few microseconds a move. A pass also takes O(n) for n vertices of the path, and a window O(p) for p
///             points of its raster: where there are fewer moves than that, there are fewer passes, and windows are
///             drawn by lot
#pragma once

#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/improve/annealing.hpp"
#include "algorithms/improve/effort.hpp"
#include "maps/problem.hpp"

namespace oxturn {

struct Annealed {
  Polyline points;
  double uncovered = 0;  // by the witnesses, square metres
  double price = 0;      // 1 / metres
  Effort effort = {};
};

/// `focus`: points where moves are needed most. `threads`: that work at a time; they do not change the result.
Annealed annealed(const Problem& problem, const Region& target, const Polyline& points,
                  const Annealing::Options& options, const Annealing::Schedule& schedule,
                  const std::vector<Point>& focus, int threads, Rng& rng, const Context& context);

}  // namespace oxturn
