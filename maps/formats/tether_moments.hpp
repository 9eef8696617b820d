// The tether at chosen moments of a path, to be drawn. Internal to maps/formats.
#pragma once

#include <vector>

#include "geometry/path.hpp"
#include "maps/problem.hpp"

namespace oxturn {

struct TetherMoment {
  Polyline line;      // anchor, bends, robot
  double length = 0;  // metres of it
  double path_m = 0;  // driven
  bool longest = false;
};

/// At `count` places equally far apart along the way, the last at its end, and where the tether is longest; in driving
/// order. Up to where a tether can follow (maps/followed_path.hpp). Tethered problems only. Twice the string's cost.
std::vector<TetherMoment> tether_moments(const Problem& problem, const Path& path, int count);

}  // namespace oxturn
