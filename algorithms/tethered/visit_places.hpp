// Places in a given order, by tethered shortest paths, then home.
#pragma once

#include <vector>

#include "algorithms/tethered/leash.hpp"

namespace oxturn {

struct VisitSettings {
  Retraction retraction = Retraction::automatic;
  std::size_t budget = 2000;  // expansions a way, of the search for other classes; see TetheredRobot::way_to
  bool return_home = true;    // with the string taken in: as it was at the start
};

/// From the problem's start. Tool on, but on the way home. Stops early if cancelled; publishes what there is now and
/// then. Reports the figures cells_missed (no way kept the string within the leash) and ways_unproven (the budget did
/// not do: the way may not be the shortest), and names missed places in a trace.
Path visit_places(const Leash& leash, const std::vector<Point>& places, const VisitSettings& settings,
                  Context& context);

}  // namespace oxturn
