/// Short straight strokes that cover uncovered points, wherever a robot can be.
///
///   for (const CoveringStroke& s : covering_strokes(points, k, space, width)) ...     // all cover point k
///
/// Positions within half the tool's width of the point, headings of the walls near by and some in all directions; from
/// each the stroke is as long as it takes to cover what it can of the uncovered points around. Where the robot has no
/// reverse gear, only strokes that it can come to and go on from (CarSpace::can_go_on).
/// Complexity  some hundred positions and headings, each O(points near by)
#pragma once

#include <vector>

#include "algorithms/smoothing/car_space.hpp"
#include "algorithms/smoothing/uncovered_points.hpp"

namespace oxturn {

struct CoveringStroke {
  Polyline points;   // two
  double gain = 0;   // square metres
  double worth = 0;  // square metres for each metre, the turns to come and go included
};

/// The best ones in different directions, those worth most first. `width`: of the tool.
std::vector<CoveringStroke> covering_strokes(const UncoveredPoints& uncovered, std::size_t target,
                                             const CarSpace& space, double width);

}  // namespace oxturn
