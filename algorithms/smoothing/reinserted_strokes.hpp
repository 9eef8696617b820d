/// Strokes that were left out of a path, inserted one after the other where each costs least.
///
///   driven = with_strokes(std::move(driven), left_out, links, problem.robot().tool_width, effort, context);
///
/// As Prim's algorithm grows a tree: always the stroke next whose insertion (linked_strokes.hpp) adds least besides its
/// own length. So the lanes of a room follow each other, and the robot does not drive to each of them from the door.
/// What an insertion costs is looked at again once a stroke near it has been inserted. Where no simple link is free to
/// any stroke, detours are searched to one after the other.
/// Complexity  for n strokes that were left out at most n rounds, each O(m log m) for m metres of path; for each stroke
///             some insertions looked at for each of its neighbours
#pragma once

#include <vector>

#include "algorithms/smoothing/linked_strokes.hpp"

namespace oxturn {

/// Those that can be inserted are. Ends early if cancelled.
std::vector<LinkedStroke> with_strokes(std::vector<LinkedStroke> driven, const std::vector<Polyline>& left_out,
                                       KnownLinks& links, double width, DetourEffort& effort, const Context& context);

}  // namespace oxturn
