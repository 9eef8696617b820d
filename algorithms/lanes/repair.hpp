/// Covers what a path leaves uncovered, so that any planner can promise the whole target.
///
///   Path path = drive_laps(...);                       // misses corners and ridges
///   path = repaired(problem, path, connector, context);
///
/// Each uncovered piece of the target gets one of these, attached to the path as a detour (outline.hpp): a stop, if the
/// tool covers the piece from one position; arcs of configuration space's boundary, if the piece is a band beside it
/// and they are shorter than lanes; else lanes along its longest diameter, or in the direction across which its hull is
/// narrowest if these are shorter, one along each corridor (corridors.hpp), and arcs beside what lanes do not reach;
/// where that is not enough, the whole ring.
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
