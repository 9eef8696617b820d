/// Level sets joined into strips that can be driven without a break.
///
///   const std::vector<Strip> strips = strips_of_runs(sets, outward);
///   const Path path = drive_strips(problem, strips, StripOrder::improved, connector, context);
///
/// A run is a sequence of level sets that follow each other outwards one to one. Its strip is driven back and forth:
///
///      .--->--.              A run of level sets no longer than the tool is wide is covered along the tether instead,
///      '---<--.              by radial lanes between its first and its last level set:
///      .--->--'
///      '---<--.                    .-.  .-.
///      .--->--'                    | |  | |
///                                  | '--' |
#pragma once

#include <vector>

#include "algorithms/lanes/strips.hpp"
#include "algorithms/tethered/level_sets.hpp"

namespace oxturn {

/// Each level set by itself, in their order.
std::vector<Strip> strips_of_sets(const std::vector<LevelSet>& sets, const Outward& outward);

/// Each run of level sets as one strip.
std::vector<Strip> strips_of_runs(const std::vector<LevelSet>& sets, const Outward& outward);

struct RadialSettings {
  std::size_t most_lanes = 4;  // of one run
  double spacing = 0;          // metres between level sets, and the width of a lane
};
/// The same, but parts of runs whose level sets are at most `most_lanes` spacings long are covered by radial lanes, as
/// many as the length needs: a level set no longer than the tool is wide is covered by passing its middle. Their first
/// and last level set are driven whole. Lanes stay in `space`.
std::vector<Strip> strips_with_radial_lanes(const std::vector<LevelSet>& sets, const Outward& outward,
                                            const EdgeIndex& space, const RadialSettings& settings);

}  // namespace oxturn
