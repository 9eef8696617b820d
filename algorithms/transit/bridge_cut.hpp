/// A cut of a tethered problem along straight bridges between obstacles, for which the tether is long enough.
///
///   if (const auto lines = bridge_cut(problem, width)) ...      // in place of the anchor's cut locus
///
/// Space that is cut open along lines which connect all obstacles with the boundary, without a cycle, is simply
/// connected, whichever lines these are: the robot's position alone determines its tether, in whatever order it covers
/// the space. The cut locus of the anchor makes every tether as short as possible, but is long itself, as it runs from
/// behind each obstacle to the next one or to a wall. Where the tether has length to spare, short bridges do:
///
///     o~~~~~~~~~~~~~~~~~|      o       |     A  anchor
///   A                   |    A :       |     ~  its cut locus
///     o~~~~~~~~~~~~~~~~~|      o.......|     :  bridges
///
/// Bridges are straight in free space, so a taut tether never crosses one: between two crossings it would enclose no
/// obstacle with the bridge, and could be shortened.
///
/// Source      ours; the trade between a shortest tree and short paths follows Khuller, Raghavachari and Young 1995
/// Method      Candidates are the edges of triangulations, and the perpendiculars from vertices to walls in their
///             triangles, that cross configuration space once, from ring to ring. Their minimum spanning tree is the
///             cut. In free space cut open like this, the geodesic distance from the anchor is measured at all vertices
///             of configuration space; along segments it is convex, so it is nowhere more. Of each run of vertices for
///             which the tether is too short, the robot's shortest paths to its ends and to the farthest are drawn, and
///             a tree of bridges that no such path crosses is sought. Only where there is none, paths are crossed,
///             those first that were asked for least often: else the same points are too far in each round.
/// Complexity  O(n log n) for n vertices of configuration space in each round, of which there are kMostRounds at most
#pragma once

#include <optional>
#include <vector>

#include "maps/problem.hpp"

namespace oxturn {

/// Lines that reach into walls; a strip `width` metres wide is to be removed along them. nullopt: no such cut was
/// found; or it was not sought, because configuration space ends where the tether does, or is so large (kMostVertices)
/// that finding it would take longer than all else. The problem's robot has a tether.
std::optional<std::vector<Polyline>> bridge_cut(const Problem& problem, double width);

}  // namespace oxturn
