/// Drops vertices that a robot cannot tell from their neighbours.
///
///   path = without_short_segments(std::move(path), problem.robot().radius / 100, connector);
///
/// A vertex nearer than `least` to the vertex before it goes, if the straight segment that replaces it is free; ends of
/// legs stay. Such vertices come from offsets that cut an arc near its end and from links between neighbouring lanes;
/// they make a controller stutter. The path moves by less than `least`. O(n), and a segment test for each short
/// segment.
#pragma once

#include "algorithms/transit/connector.hpp"
#include "geometry/path.hpp"

namespace oxturn {

Path without_short_segments(Path path, double least, const Connector& connector);

}  // namespace oxturn
