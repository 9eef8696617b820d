/// A drivable path around obstacles by OMPL: trees of random poses.
///
///   const std::optional<Curve> detour = ompl_search(space, {from}, to, context);
///
/// Source      LaValle, Rapidly-exploring random trees, 1998 (forward only); Kuffner and LaValle, RRT-Connect, ICRA
///             2000 (reverse), as in OMPL (Sucan, Moll and Kavraki 2012)
/// Method      States are poses, motions the shortest Dubins curves (in reverse Reeds-Shepp curves), tested exactly.
///             The path found is shortened: of the poses along it, one radius apart, those of the shortest sequence of
///             free curves are kept.
/// Guarantee   The same problem, seed and poses give the same path: poses are drawn by a generator of ours, and the
///             search ends after a number of them, not of seconds.
/// Complexity  at most 5000 poses: some tenths of a second. Longer than paths of lattice_search.hpp in open space, but
///             not limited to steps of a lattice
#pragma once

#include <optional>
#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/smoothing/curve.hpp"

namespace oxturn {

class CarSpace;

/// From any of the poses `from`. nullopt: none was found.
std::optional<Curve> ompl_search(const CarSpace& space, const std::vector<Pose>& from, const Pose& to,
                                 const Context& context);

}  // namespace oxturn
