// Places in a given order, by tethered shortest paths, then home.
#pragma once

#include <vector>

#include "algorithms/transit/tether_space.hpp"

namespace oxturn {

struct VisitSettings {
  Retraction retraction = Retraction::automatic;
  std::size_t budget = 2000;  // expansions a way, of the search for other classes; see TetheredRobot::path_to
  bool return_home = true;    // with the string taken in: as it was at the start
};

/// From the problem's start. Tool on, but on the way home. Stops early if cancelled; publishes what there is now and
/// then. Reports the figures cells_missed (no way kept the string within the leash) and paths_unproven (the budget did
/// not do: the way may not be the shortest), and names missed places in a trace.
Path visit_points(const TetherSpace& leash, const std::vector<Point>& places, const VisitSettings& settings,
                  Context& context);

}  // namespace oxturn
