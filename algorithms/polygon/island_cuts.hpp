/// A region with islands as simply connected parts, each of which has a spiral with steps as even as possible.
///
///   const std::vector<Region> parts = decomposed(space, {.cut = w / 1000, .chord = w / 100, .start_height = 1.5});
///
///     +-----------------+      Bridges connect all islands with the boundary: one part, whose laps crowd where they
///     |     |           |      pass an island. A further cut between two rings divides a part in two.
///     |   .---.         |
///     |   |   |---------|      What the cuts make least:
///     |   '---'         |        max SOV + 0.8 (k - 1) + 0.5 / (k - 1) sum |pi / b - 1|
///     +-----------------+
///
/// for k parts. SOV, the step-over variation of a part, is the greatest distance between laps over the least one. b is,
/// for each cut that divides a part, the angle between it and the cut at the same island that continues it best: pi
/// if both are one straight line. (The source weighs angles of cuts; that these are meant is our reading.)
///
/// Source      Held and Spielberger, "Improved spiral high-speed machining of multiply-connected pockets",
///             Computer-Aided Design and Applications 11(3), 2014
/// Method      Greedy: the part with the greatest SOV is cut by the best of some candidates, the lines between rings
///             that divide its boundary most evenly, as long as fewer parts could pay; then the number of cuts with the
///             least sum is kept.
/// Complexity  at most SOV / 0.8 cuts; for each, 16 medial axes of parts of the one that is cut
#pragma once

#include <vector>

#include "algorithms/context.hpp"
#include "geometry/region.hpp"

namespace oxturn {

struct IslandCuts {
  double cut = 1e-3;          // metres: width of bridges and cuts
  double chord = 1e-2;        // metres: error of the axis' parabolas
  double start_height = 1.5;  // greatest clearances: what is higher above the boundary is time 0; infinity: the root
};

/// The region cut open by its shortest bridges: one polygon without holes for each connected component.
Region bridged(const Region& region, double cut);
/// Polygons without holes. Ends early if cancelled.
Region decomposed(const Region& region, const IslandCuts& options, const Context& context);

}  // namespace oxturn
