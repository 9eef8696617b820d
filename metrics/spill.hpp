/// How much a tool must sweep outside of the target, whatever path it takes: at corners, and where the target is
/// narrower than the tool.
///
///   const double spill = least_spill(problem.target(), tool_width, uncovered_m2, {});
///   const double metres = (covered_m2 + spill - kPi * w * w / 4) / w;     // no path that covers as much is shorter
///
/// Let T be the target, r = w/2, and p_1, p_2, ... points of T, the witnesses, with disjoint convex cells V_k about
/// them. Let d_k be the distance from p_k to the path, less r. Some disc of the tool has its centre c within r + d_k of
/// p_k, and sweeps area((B(c, r) \ T) n V_k) outside of T within V_k. The least of that over all such c is
/// s_k(d_k), which does not increase with d_k. If d_k > 0, no point of T within d_k of p_k is covered: within V_k that
/// is an uncovered area of b_k(d_k) = area(B(p_k, d_k) n T n V_k), which does not decrease with d_k. The cells are
/// disjoint, so
///
///     swept area outside T >= sum s_k(d_k),     uncovered area of T >= sum b_k(d_k).
///
/// The first sum is made least under the condition that the second is no more than the uncovered area. Distances are
/// divided into intervals [d_j, d_j+1) with cost b_k(d_j) and spill s_k(d_j+1); the linear relaxation of this
/// multiple-choice knapsack is a lower bound of its solution. Each s_k is found by branch and bound over squares of
/// centres: all discs with centres within h of m contain B(m, r - h), and none sweeps less than that about m by more
/// than 2 r h. Only bounds from below are used, so the result is certified up to rounding, for which it is reduced.
///
/// Where the path begins is known: what the tool's disc there sweeps comes without driving. If `start` is given, that
/// disc counts as part of T in what is spilled, and (covered + spill - area(B(start, r) n T)) / w is a bound that is at
/// least as good.
///
/// Witnesses are the vertices of the target and points a quarter of the width apart on its boundary, those with the
/// greatest spill first, none nearer to another than a given distance; cells are those of their Voronoi diagram.
/// Some milliseconds for each witness. The work is bounded to about a second: of targets with long and winding
/// boundaries not all that is spilled is found.
/// Source: ours. The bound by area alone is folklore.
#pragma once

#include <optional>

#include "geometry/region.hpp"

namespace oxturn {

/// Square metres, at least 0. `width`: the tool's. `uncovered_m2`: of the target at most. `start`: outside of the
/// tool's disc there.
double least_spill(const Region& target, double width, double uncovered_m2, const std::optional<Point>& start);

}  // namespace oxturn
