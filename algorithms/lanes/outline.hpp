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

/// Configuration space with fewer vertices on the arcs around obstacles: tangents keep off an arc by at most a
/// hundredth of the robot's radius. Most stay where the tool is narrower than the robot: it would leave seams there.
/// A lap along the boundary covers what one along that of configuration space covers. The problem's start stays inside.
/// O(n log n).
Region coarser_space(const Problem& problem);
/// What laps follow: the coarser space, with straighter walls inside the given ones if those are staircases, as in
/// maps traced from images, along which a robot would shake. Vertices that stick out of free space by less than a
/// twentieth of the tool's width are removed (or a fortieth, and so on: so that at most 0.0005 of the target is
/// missed). A lap along the straighter boundary covers all of configuration space that one along the other covers; what
/// it misses is a seam at the wall no wider than that tolerance. O(n log n).
Region straightened_space(const Problem& problem);

/// Inserts the boundary rings of straightened_space(); then drops vertices nearer to each other than a hundredth of the
/// robot's radius (transit/short_segments.hpp). About O(n) for n segments if every ring lies within a few widths
/// of the path or of another ring; each doubling of the distance to the farthest ring costs another pass.
Path with_outline(const Problem& problem, const Path& path, double width, const Connector& connector, Context& context);
/// The same with any rings in configuration space. Those of two points are driven there and back. No wall of the space
/// may lie between a ring and what is nearest to it, so the boundary belongs to the rings or to the path.
Path with_rings(const Problem& problem, const std::vector<Ring>& rings, const Path& path, double width,
                const Connector& connector, Context& context);
/// The same with the boundary of a region that lies in configuration space.
Path with_rings(const Problem& problem, const Region& region, const Path& path, double width,
                const Connector& connector, Context& context);
/// The same with rings anywhere in configuration space: each is attached where the drive there is shortest.
Path with_detours(const Problem& problem, const std::vector<Ring>& detours, const Path& path, double width,
                  const Connector& connector, Context& context);
/// The strips (drive_strips), and with `outline` the walls as well, a tool width from the path. Publishes both.
Path drive_strips_and_walls(const Problem& problem, const std::vector<Strip>& strips, StripOrder order, bool outline,
                            Context& context);

}  // namespace oxturn
