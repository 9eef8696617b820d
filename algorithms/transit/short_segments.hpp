/// Drops vertices that a robot cannot tell from their neighbours.
///
///   path = without_short_segments(std::move(path), problem);
///
/// A vertex nearer than a hundredth of the robot's radius, or of its tool's width if that is less, to the vertex before
/// it goes, if the straight segment that replaces it is free; otherwise the two become one where that is free. Ends of
/// legs stay. Such vertices come from offsets that cut an arc near its end, from links between neighbouring lanes and
/// from bumps; they make a controller stutter. The path moves by less than that. O(n), and segment tests for each short
/// segment.
#pragma once

#include <algorithm>

#include "geometry/path.hpp"
#include "maps/problem.hpp"

namespace oxturn {

/// Vertices nearer to each other are one for a robot that size. Links between the lanes of a narrow tool are longer.
inline double shortest_segment(const Robot& robot) { return std::min(robot.radius, robot.tool_width) / 100; }

Path without_short_segments(Path path, const Problem& problem);

}  // namespace oxturn
