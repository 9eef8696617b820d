// Laps: places at equal tether length, as far as driving them is of use, and how they lie beside each other.
#pragma once

#include <vector>

#include "algorithms/lanes/strips.hpp"
#include "algorithms/transit/tether_space.hpp"

namespace oxturn {

/// One piece of a level set, counter-clockwise about the anchor (the string at the left).
struct LevelSet {
  std::size_t level = 0;  // at distance (level + 1/2) * spacing
  Polyline line;
};

/// Laps `spacing` apart in `inner`, which lies in `space` (all parts of the cut space); the boundary of `inner` is driven
/// by somebody else. They are left out where no point farther than spacing / 2 from that boundary needs them: every point of `inner` is within spacing / 2 of a
/// lap or of the boundary. In order of distance, then round the anchor. Chord error at most `chord`.
/// O(levels * (arcs + triangles) + length / spacing * log) for the whole.
std::vector<LevelSet> laps(const TetherSpace& leash, const Region& space, const Region& inner, double spacing, double chord);

/// For each lap the laps one level farther out that lie beside it. Ascending.
std::vector<std::vector<std::size_t>> outward_neighbours(const std::vector<LevelSet>& laps, const GeodesicField& field,
                                                         double spacing);

/// Runs of laps that follow each other one to one become strips (driven back and forth); `neighbours` join them. Runs of
/// laps at most `lanes` spacings long (0: none) are swept by so many lanes along the string instead, between their first
/// and their last lap: a lap no longer than the tool is wide is covered by passing its middle. `space`: where the robot
/// may drive. `single`: every lap by itself.
std::vector<Strip> strips_of(const std::vector<LevelSet>& laps, const std::vector<std::vector<std::size_t>>& outward,
                             const EdgeIndex& space, double spacing, int lanes, bool single);

}  // namespace oxturn
