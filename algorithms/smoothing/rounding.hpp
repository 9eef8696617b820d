/// Rounds the corners of a polyline where a car-like robot can, and cuts it where it cannot.
///
///   for (Polyline& run : rounded_runs(line, space)) strokes.push_back(std::move(run));
///
///            X . . . . e
///          .     .-'       An arc of the least turning radius R touches both edges at R tan(d / 2) from the
///        .     /           point X where their lines meet, d being the change of heading. Edges too short for
///      a ----'             their arcs are left out, so one arc may replace several vertices.
///
/// A vertex is kept if a curve of radius R, sampled as paths must be, may have it. Elsewhere, and where the arc meets
/// an obstacle or the robot turns by more than 120 degrees, the polyline is cut. O(n) for n vertices.
#pragma once

#include <vector>

#include "algorithms/smoothing/car_space.hpp"

namespace oxturn {

/// Each run can be driven in both directions. A closed polyline gives one closed run if all its corners can be rounded.
std::vector<Polyline> rounded_runs(const Polyline& line, const CarSpace& space);

}  // namespace oxturn
