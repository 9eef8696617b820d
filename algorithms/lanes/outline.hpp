/// Drives every wall once, tool on: closed rings inserted into an existing path.
///
///   Path path = drive_strips(...);                                    // the interior
///   path = with_outline(problem, path, tool_width, connector, context);
///
/// Each boundary ring of configuration space becomes a detour: it leaves the path where the path comes nearest to the
/// ring, goes once round the ring and returns to the same point. Rings far from the path are attached to other rings,
/// the nearest first (Prim's algorithm), so rings alone cover a system of corridors. The connection from path to ring
/// is driven with the tool on if it is at most `width` long, else as transit.
///
///     path  ------->--.  .--------->
///                     |  |
///                  .--'  '--.
///                  |  ring  |
///                  '--------'
#pragma once

#include "algorithms/lanes/strips.hpp"

namespace oxturn {

/// Inserts the boundary rings of configuration space. About O(n) for n segments if every ring lies within a few widths
/// of the path or of another ring; each doubling of the distance to the farthest ring costs another pass.
Path with_outline(const Problem& problem, const Path& path, double width, const Connector& connector, Context& context);
/// The same with the rings of `rings`, which lies in configuration space.
Path with_rings(const Problem& problem, const Region& rings, const Path& path, double width, const Connector& connector,
                Context& context);
/// The strips (drive_strips), and with `outline` the walls as well, a tool width from the path. Publishes both.
Path drive_strips_and_walls(const Problem& problem, const std::vector<Strip>& strips, StripOrder order, bool outline,
                            Context& context);

}  // namespace oxturn
