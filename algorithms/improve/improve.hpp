/// Makes coverage paths shorter: annealing at length, then closed to the coverage that is asked for.
///
///   const Path shorter = improved(problem, {{path}}, {.coverage = 0.99, .moves = 1'000'000}, context);
///
/// Of several paths, each is annealed briefly (annealing.hpp), and the best one at length, or the same path without its
/// detours, if there is one: annealing covers what they covered on less length. Hot first, then cold (the start itself,
/// if hot annealing made it longer) and, for nearly full coverage, on a finer raster of witnesses. The
/// first run at length leaves more uncovered than is asked for: lanes move little where nothing may be left. After
/// each round what the path leaves uncovered is found exactly, and detours (lanes/repair.hpp) are added until the
/// coverage is reached. The next round goes on with them; not so the first one where coverage is nearly full, because
/// there are many, and annealing covers what is left on less length. The shortest of all completed paths is the result,
/// so the coverage never depends on convergence, and the result is never longer than any path given, completed in the
/// same manner. The tool is on all along.
///
/// Where all of the target is asked for, and there are fewer than ten moves for each square of the tool's width, none
/// is made: the best path given is the result, completed if not all of the paths given are complete.
///
/// With `objective = time`, a turn counts as far as the robot drives while it turns on the spot, and the path is the
/// one that takes the least time in this sense; of completed paths, turns smaller than what the robot rounds off do not
/// count. With `objective = weighted`, it is the one with the least
/// (1 - time_weight) * length + time_weight * speed * time: a turn counts the share `time_weight` of that.
///
/// The effort is counted: records annealing_moves, raster_points and measured_vertices (effort.hpp).
///
/// Source      ours
/// Complexity  a few microseconds a move, and O(m log m) for a path of m segments in each round; there are as many
///             rounds, up to ten, as the moves pay for
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/planner_info.hpp"
#include "base/parameters.hpp"
#include "maps/problem.hpp"

namespace oxturn {

struct Improvement {
  double coverage = 1;       // share of the target
  int moves = 0;             // of annealing; 0: by the size of the target
  bool return_home = false;  // the path ends where it starts
  double temperature = 0;    // to begin with, in tool widths; 0: by the moves for the size of the target
  int threads = 1;           // which does not change the result
  std::string objective = "length";
  double time_weight = 0.5;      // with objective = weighted
  std::string without = "none";  // a part that is left out (part.hpp)
};
/// Their description, for planners that improve paths.
const std::vector<Parameter<Improvement>>& improvement_parameters();
/// What the descriptions of planners that improve paths have in common; without `make`.
PlannerInfo improving_planner(const std::string& name, const std::string& title, const std::string& guarantee);

/// Is the tool wider than four robots?
bool is_wide_tool(const Robot& robot);
/// How many moves of annealing are made in all: `how.moves`, or what the size of the target gives.
double moves_in_all(const Improvement& how, const Problem& problem);
/// Are these enough for the target's size to cover what a path leaves uncovered without its detours?
bool enough_for_unrepaired(const Improvement& how, const Problem& problem);

struct PathToImprove {
  Path path;
  // The same without detours for what its lanes leave uncovered: annealed at length instead.
  std::optional<Path> unrepaired = std::nullopt;
  bool complete = false;  // it covers the whole target, but for seams thinner than covered_seam() (lanes/uncovered.hpp)
};

/// `starts`: at least one path. Publishes what it finds. Returns the best path so far if cancelled.
/// Throws Infeasible if there is nothing to drive.
Path improved(const Problem& problem, const std::vector<PathToImprove>& starts, const Improvement& how,
              Context& context);

}  // namespace oxturn
