/// A drivable path around obstacles, from any of some poses to another one: two searches.
///
///   const std::optional<Curve> detour = lattice_search(space, {from}, to, context);   // nullopt: none was found
///
/// lattice_search: hybrid A* over position and heading
///   Source      Dolgov, Thrun, Montemerlo and Diebel, Path Planning for Autonomous Vehicles in Unknown Semi-structured
///               Environments, IJRR 29(5), 2010
///   Method      Steps of 1.5 cells, steering left, straight or right (in both gears if the robot has them), from exact
///               poses; of those in one cell of a quarter radius and five degrees the cheapest is kept. Heuristic: the
///               shortest curve without obstacles, which is also tried as the rest of the path.
///   Complexity  at most 20000 poses, each with a few curves: up to a second
///
/// ompl_search: trees of random poses, by OMPL
///   Source      LaValle, Rapidly-exploring random trees, 1998 (forward only); Kuffner and LaValle, RRT-Connect, ICRA
///               2000 (reverse), as in OMPL (Sucan, Moll and Kavraki 2012)
///   Method      States are poses, motions the shortest Dubins curves (in reverse Reeds-Shepp curves), tested exactly.
///               The path found is shortened: of the poses along it, one radius apart, those of the shortest sequence
///               of free curves are kept.
///   Guarantee   The same problem, seed and poses give the same path: poses are drawn by a generator of ours, and the
///               search ends after a number of them, not of seconds.
///   Complexity  at most 5000 poses: some tenths of a second. Longer than paths of lattice_search in open space, but
///               not limited to steps of a lattice
#pragma once

#include <optional>
#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/smoothing/curve.hpp"

namespace oxturn {

class CarSpace;

std::optional<Curve> lattice_search(const CarSpace& space, const std::vector<Pose>& from, const Pose& to,
                                    const Context& context);
std::optional<Curve> ompl_search(const CarSpace& space, const std::vector<Pose>& from, const Pose& to,
                                 const Context& context);

}  // namespace oxturn
