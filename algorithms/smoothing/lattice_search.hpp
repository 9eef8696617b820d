/// A drivable path around obstacles: hybrid A* over position and heading.
///
///   const std::optional<Curve> detour = lattice_search(space, {from}, to, context);
///
/// Source      Dolgov, Thrun, Montemerlo and Diebel, Path Planning for Autonomous Vehicles in Unknown Semi-structured
///             Environments, IJRR 29(5), 2010
/// Method      Steps of 1.5 cells, steering left, straight or right (in both gears if the robot has them), from exact
///             poses; of those in one cell of a quarter radius and five degrees the cheapest is kept. Heuristic: the
///             shortest curve without obstacles, which is also tried as the rest of the path.
/// Complexity  at most 20000 poses, each with a few curves: up to a second
#pragma once

#include <optional>
#include <vector>

#include "algorithms/context.hpp"
#include "algorithms/smoothing/curve.hpp"

namespace oxturn {

class CarSpace;

/// From any of the poses `from`. nullopt: none was found.
std::optional<Curve> lattice_search(const CarSpace& space, const std::vector<Pose>& from, const Pose& to,
                                    const Context& context);

}  // namespace oxturn
