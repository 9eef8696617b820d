/// The tether at chosen moments of a path, for pictures. Private to maps/formats.
///
///   for (const TetherMoment& m : tether_moments(problem, path, 8)) draw(m.line);
#pragma once

#include <vector>

#include "geometry/path.hpp"
#include "maps/problem.hpp"

namespace oxturn {

struct TetherMoment {
  Polyline line;         // anchor, bends, robot
  double length = 0;     // metres, of the tether
  double path_m = 0;     // metres driven until then
  bool longest = false;  // the tether is never longer than here
};

/// At `count` points of the path, equally far apart, the last at its end, and where the tether is longest; in driving
/// order. Up to where a tether can follow (maps/followed_path.hpp). Tethered problems only. Simulates the tether twice.
std::vector<TetherMoment> tether_moments(const Problem& problem, const Path& path, int count);

}  // namespace oxturn
