/// A lower bound of the length of a path where configuration space is narrow: dead ends must be driven in and out.
///
///   const std::optional<double> metres = arm_bound(problem, uncovered_m2, first_m2);
///
/// No path that covers as much is shorter.
///
/// Let f(x) be the length of the shortest path from the start to x in configuration space C. Along a path f changes by
/// no more than is driven. So a path is at least as long as the integral over all t > 0 of the number of times at which
/// it is at distance t. Let D be a component of {f > t}. A path that enters D, and begins outside, is at distance t on
/// the boundary of D at least once, and twice unless it ends in D. If it does not enter D, it leaves uncovered what can
/// only be covered from D.
///
/// Choose a set A of parts of C, each between two distances in one branch of the tree of these components
/// (level_tree.hpp). In A, count as above. Outside of A, count area: let S(A) be what of the target no disc of the tool
/// with a centre in A covers. Whenever the path comes from A, its tool covers nothing of S(A) at first, and then not
/// more than w times what is driven; if it starts outside of A, what its first disc covers (`first`) is added.
/// So
///
///     length >= sum of the counts in A + (area of S(A) - first) / w.
///
/// A path that leaves the area u uncovered may leave out components of the tree. To leave out D saves at most the count
/// c(D) of all that lies in D and A, and costs what can only be covered from D, of area a(D), of which b(D) is part of
/// S(A) and missing there as well. Components left out are disjoint, so all savings together are at most u times the
/// greatest of 1 / w and (c(D) + b(D) / w) / a(D) over all D with a(D) <= u. Components with less of their own than
/// some small area are not counted at all.
///
/// The path ends somewhere. For each dead end there is the bound of paths that end there, which counts all parts
/// between it and the start once; A may be another for each. The least of them is the result. A is chosen by dynamic
/// programming over estimates; any choice is valid.
///
/// Distances hold for squares of an eighth of the tool width; they and areas are rounded to the safe side. Nothing is
/// looked for on maps of more than 250,000 such squares, and where C is nowhere narrower than about the tool: that is
/// found in some milliseconds. Otherwise it takes some 0.1 s for 1,000 tool squares.
/// Source: ours.
#pragma once

#include <optional>

#include "maps/problem.hpp"

namespace oxturn {

/// `uncovered_m2`: of the target at most. nullopt: there is no such bound. It holds for valid paths only.
/// `first_m2`: of the target under the tool's disc at the start at most.
std::optional<double> arm_bound(const Problem& problem, double uncovered_m2, double first_m2);

}  // namespace oxturn
