/// Level sets of geodesic distance from the anchor, trimmed to what coverage needs, and their adjacency.
///
///   const std::vector<LevelSet> sets = level_sets(space, region, inner, tool_width, tool_width / 1000);
///   const Outward outward = outward_neighbours(sets, space.field(), tool_width);
///
///        ------.           Level k is at distance (k + 1/2) * spacing. Driven with a tool as wide as the spacing, the
///        ----.  \          level sets cover everything except the surroundings of the boundary, where they end.
///        --.  \  |
///       o   |  | |         o: the anchor
#pragma once

#include <vector>

#include "algorithms/transit/tether_space.hpp"

namespace oxturn {

/// In spacings: as much longer than coverage needs a piece of a level set may be at each end.
inline constexpr double kLevelSetTrim = 0.04;

/// One connected piece of a level set, counter-clockwise about the anchor: driven like this, the robot has the tether
/// on its left.
struct LevelSet {
  std::size_t level = 0;  // at distance (level + 1/2) * spacing
  Polyline line;
  /// The line's beginning (end) is trimmed: the driven boundary covers what follows. Otherwise it lies at a part of the
  /// cut that is not driven.
  bool trimmed_begin = true, trimmed_end = true;
};

/// The level sets in `inner`, which lies in `region`, the space where the robot may drive; the boundary of `inner` is
/// driven separately. Pieces are omitted where no point farther than spacing / 2 from that boundary needs them: every
/// point of `inner` is within spacing / 2 of a level set or of the boundary. By level, then round the anchor. Chord
/// error at most `chord` metres. O(levels * (arcs + triangles) + length / spacing * log) in all.
std::vector<LevelSet> level_sets(const TetherSpace& space, const Region& region, const Region& inner, double spacing,
                                 double chord);

/// For each level set the ones beside it one level farther out, ascending.
using Outward = std::vector<std::vector<std::size_t>>;
Outward outward_neighbours(const std::vector<LevelSet>& sets, const GeodesicField& field, double spacing);

}  // namespace oxturn
