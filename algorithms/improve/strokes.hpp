/// A short detour along a piece that covers it, where no single position does.
///
///   if (const auto detour = stroke(segments, piece.outer, 0.499 * w, connector, walls)) ...
///
///     --->--.   .--->---        For points of the piece's outline, the positions of configuration space that cover
///            | |                them, as near to the path as they can be. The robot visits the two that are farthest
///      ._____|_|__.             from each other, and others where the outline is not covered yet.
///      ~~~~~~~~~~~~ wall
///
/// Complexity  O(n^2) for n vertices of the piece, at most a hundred
#pragma once

#include <optional>

#include "algorithms/improve/detours.hpp"

namespace oxturn {

/// nullopt if the path is too far, or behind a wall.
std::optional<Detour> stroke(const NearbySegments& path, const Polyline& outline, double reach,
                             const Connector& connector, const EdgeIndex& walls);

}  // namespace oxturn
