/// Makes a coverage path shorter: annealing at length, then closed to the coverage that is asked for.
///
///   const Path shorter = improved(problem, path, {.coverage = 0.99, .moves = 1'000'000}, context);
///
/// The path is annealed on a raster of witnesses (annealing.hpp), first coarse and hot, then fine and cold. After each
/// round what it leaves uncovered is found exactly, and detours (lanes/repair.hpp) are added until the coverage is reached.
/// The best of these paths is the result, so the coverage never depends on convergence, and the result is never longer
/// than the path to begin with, completed in the same way. The tool is on all along.
///
/// Source      ours
/// Complexity  a few microseconds a move, and O(m log m) for a path of m segments in each round
#pragma once

#include <vector>

#include "algorithms/context.hpp"
#include "base/parameters.hpp"
#include "maps/problem.hpp"

namespace oxturn {

struct Improvement {
  double coverage = 1;  // share of the target
  int moves = 0;        // of annealing; 0: by the size of the target
};
/// Their description, for planners that improve paths.
const std::vector<Parameter<Improvement>>& improvement_parameters();
/// Whether with these settings of a planner the whole target is covered.
bool covers_all(const Settings& settings);

/// Publishes what it finds. Returns the best path so far if cancelled.
Path improved(const Problem& problem, const Path& path, const Improvement& how, Context& context);

}  // namespace oxturn
