/// How short a path could be that covers as much of the target as a given one: the best of several lower bounds.
///
///   const std::optional<LengthBound> bound = length_bound(problem, path, swept_area(...), true);
///   path.length() >= bound->metres;                 // for every path whose legs join
///
/// area    approach + (covered - first) / w: a curve of length L sweeps at most L w beyond the tool's disc at its
///         start. `first` is what of the target that disc covers, at most pi w^2 / 4. Where it covers nothing,
///         `approach` is the shortest path to where something can be covered; what is driven after that sweeps w times
///         as much at most
/// spill   the same with what the tool must sweep outside of the target added to what is covered (spill.hpp). A tool no
///         wider than the robot spills nothing where all of the map is the target, so it is not looked for there; nor
///         where legs use a part of the tool, since a narrower one spills less
/// arms    narrow parts of configuration space by the number of times they must be driven along, the rest by area
///         (arm_bound.hpp). Only of valid paths: one that drives through walls may be shorter.
///         Neither do other paths have an approach, or the tour
/// tour    some points of a small target one after the other (tour_bound.hpp)
#pragma once

#include <optional>

#include "maps/problem.hpp"
#include "metrics/swept_area.hpp"

namespace oxturn {

struct LengthBound {
  enum class Kind { area, spill, arms, tour } kind;
  double metres;
};

/// nullopt if no more than about one tool disc is covered. `swept`: of this path, whose legs join; `valid`:
/// find_flaw() finds nothing.
std::optional<LengthBound> length_bound(const Problem& problem, const Path& path, const SweptArea& swept, bool valid);

}  // namespace oxturn
