/// Covers what a path leaves uncovered, so that any planner can promise the whole target.
///
///   Path path = drive_laps(...);                       // misses corners and ridges
///   path = repaired(problem, path, connector, context);
///
/// Each uncovered piece of the target gets one of these, attached to the path as a detour (outline.hpp): a stop, if the
/// tool covers the piece from one position; lanes along the shortest of four directions, one along each corridor
/// (corridors.hpp), and arcs of configuration space's boundary beside what lanes do not reach; or, if it is shorter,
/// such arcs first, and lanes for what they leave, as in an aisle a little wider than two tools; where that is not
/// enough, the whole ring.
///
/// Guarantee   covers the target but for pieces below 1e-6 w^2 and seams thinner than w / 250 (w: tool width), for the
///             following reason. Let p be a point of an uncovered piece U, and f its foot on the lane of its slab. If f
///             is in configuration space C, the lane covers p, because |pf| <= w/2. Otherwise the boundary of C passes
///             p within w/2: pf crosses it, or p lies outside of C, but within w/2 of it, as every point of the target
///             does. Then the nearest point of that boundary covers p.
/// Complexity  O(m log m) for a path of m segments (none if the caller knows what is uncovered), and for each uncovered
///             piece what its lanes cost
#pragma once

#include "algorithms/coverage_planner.hpp"
#include "algorithms/lanes/uncovered.hpp"
#include "algorithms/transit/connector.hpp"

namespace oxturn {

/// The path with detours; the path itself, if nothing is missing. Traces "repair": the pieces. Ends early if cancelled.
Path repaired(const Problem& problem, const Path& path, const Connector& connector, Context& context);
/// The same if the caller knows what of the target is uncovered.
Path repaired(const Problem& problem, const Path& path, Region missed, const Connector& connector, Context& context);

}  // namespace oxturn
