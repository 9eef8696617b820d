/// Makes a path drivable for a robot with a least turning radius, whatever planner it comes from.
///
///   const Path path = drivable(problem, planned, context);
///
///     planned           drivable, forward only       with reverse
///     |  |  |  |            .-.   .---.                |  |
///     |  |  |  |           (   ) /     \               |  |
///     '--'  '--'            '. .'       |               \ | ->
///
/// What the planner drives with the tool on is cut into strokes (strokes.hpp): lanes, laps, whatever the robot can
/// follow. They keep their course; a tour over Dubins or Reeds-Shepp links chooses their order and direction, so that
/// lanes too near to each other for a turn are not driven one after the other. Links are tested exactly (car_space.hpp)
/// and driven with the tool off, unless they cover something; where one is blocked the tour is improved with what it
/// really costs. The robot starts with the heading that suits it.
///
/// Rounded corners, dead ends and lanes without a link leave parts of the target uncovered. These are visited by short
/// strokes inserted into the path (drivable_visits.hpp), until no more is uncovered than the planner's own path leaves
/// (or 0.05 % of the target, if that is more), or no visit is found that gets there and away again and covers a
/// thousandth of the tool's width for each metre that it adds. What no drivable path covers stays uncovered: forwards,
/// corners sharper than the robot turns.
///
/// Source      ours; lane orders after Bochtis and Vougioukas 2008, links after Dubins 1957, Reeds and Shepp 1990
/// Guarantee   the path keeps min_turn_radius and stays in configuration space. Coverage is not guaranteed: a detour
///             that exists may not be found
/// Complexity  for m strokes, O(m log m) link lengths and some tens of m exact link tests; for each uncovered piece
///             some hundred short strokes
#pragma once

#include "algorithms/context.hpp"
#include "algorithms/smoothing/car_space.hpp"
#include "maps/problem.hpp"

namespace oxturn {

/// Throws Infeasible with the position if the robot cannot get to, or not out of, more than a tenth of the strokes by
/// length, and visits do not make up for them: a tenth of the target stays uncovered besides what the path leaves.
/// Records "lanes_left_out_m": the length of strokes without a link, before visits. Traces "strokes". Publishes what
/// can be driven so far. Ends early if cancelled. `search`: who looks for detours where links are blocked.
Path drivable(const Problem& problem, const Path& path, Context& context, DetourSearch search = DetourSearch::lattice);

}  // namespace oxturn
