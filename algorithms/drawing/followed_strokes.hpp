/// Makes strokes drivable for a robot with a least turning radius: those with sharp bends become pieces.
///
///   follow_strokes(elements, demands, curves, {.radius = 0.5, .deviation = 0.008});
///
/// A stroke with bends sharper than the radius (followed_line.hpp) gets several legs, with transits in between: the
/// robot lifts the tool, makes a loop and goes on in the new direction. A closed stroke with such a bend is opened: at
/// the node where a person connects it, else at its sharpest bend. Demands and curves that name it are changed with it.
/// Source: Vollprecht 2014, section 3.7 (rounding outside), for curves too.
#pragma once

#include "algorithms/drawing/demands.hpp"
#include "algorithms/drawing/followed_line.hpp"
#include "algorithms/drawing/order_driver.hpp"

namespace oxturn {

void follow_strokes(std::vector<DrawingElement>& elements, TourDemands& demands, PortCurves& curves,
                    const FollowOptions& options);

}  // namespace oxturn
