/// The parts of improvement (improve.hpp) that can be left out, to measure what each of them is worth.
///
///   const AnnealingPart without = part_named("covering");
#pragma once

#include <string>
#include <vector>

namespace oxturn {

enum class AnnealingPart {
  none,
  starts,      // all but the first; planners that have one only: nothing
  laps,        // of starts, at half the tool's width from walls; planners that have one start only: nothing
  unrepaired,  // starts without their detours; planners that have none: nothing
  heat,        // no move makes the path worse
  windows,     // large paths are annealed as a whole
  reordering,  // moves that drive parts in another order or direction
  covering,    // moves that cover an uncovered point
  walls,       // moves of vertices and edges onto the wall beside them, and the same before each round of closing
  focus,       // most moves of closing near what is uncovered
  closing,     // its moves are made before, and detours added once
  strokes,     // detours along walls
  detours      // short ones, by stops and strokes: all are those of lanes/repair.hpp
};
/// In the order of AnnealingPart.
const std::vector<std::string>& part_names();
/// Throws std::invalid_argument for a name that is none of them.
AnnealingPart part_named(const std::string& name);

}  // namespace oxturn
