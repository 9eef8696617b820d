/// Parallel lanes: a rotated frame in which lanes are vertical, and the part of a region that lies in each slab.
///
///   const LaneFrame frame(30);                                  // lanes at 30 degrees
///   const Region rotated = frame.to_frame(region);
///   const Box box = bounding_box(rotated);
///   const Slabs slabs = slabs_over(box.low.x(), box.high.x(), tool_width);
///   const Projection lanes = project(edges_of(rotated), slabs); // lanes.intervals, in the frame
///
/// The plane is divided into slabs of equal width. The lane of a region in a slab is the projection of the region's
/// part in that slab onto the slab's centre line:
///
///                       |   .   /|      The region lies below the slanted edge. The lane of a slab (dotted) spans
///                       |   . /  |      every height that the region reaches anywhere in the slab. A tool as wide as
///              |   .   /|   /    |      the slab that drives the lane passes over each point of the region at the
///              |   . /  | / .    |      point's own height, however the boundary runs inside the slab: nothing is
///     |   .   /|   /    |   .    |      sampled.
///     |   . /  | / .    |   .    |
///     +--------+--------+--------+
///       slab 0   slab 1   slab 2
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/edge_index.hpp"
#include "geometry/region.hpp"
#include "maps/problem.hpp"

namespace oxturn {

/// Rotates the plane so that lanes of a given direction become vertical. Multiples of 90 degrees are exact.
class LaneFrame {
 public:
  /// `lane_degrees`: the lanes' direction, counter-clockwise from +x.
  explicit LaneFrame(double lane_degrees);
  Point to_frame(const Point& p) const { return {c_ * p.x() - s_ * p.y(), s_ * p.x() + c_ * p.y()}; }
  Point to_world(const Point& p) const { return {c_ * p.x() + s_ * p.y(), c_ * p.y() - s_ * p.x()}; }
  Region to_frame(const Region& region) const;

 private:
  double c_, s_;  // cosine and sine of the rotation
};

/// What lanes must cover if the boundary of configuration space C is driven as well: a superset of the points of C at
/// least `inset` metres from its boundary, larger only by the chords of round vertices, which lie up to `chord` metres
/// too far out. Never leaves C, as long as `chord` is less than `inset`. Made from the map in one step (radius +
/// inset), because eroding C again would round every vertex twice; but from C where C ends elsewhere than near walls.
Region lane_region(const Problem& problem, double inset, double chord);

struct Segment {
  Point a, b;
};
/// Appends the edges of the ring.
void add_ring(std::vector<Segment>& edges, const Ring& ring);
std::vector<Segment> edges_of(const Region& region);

/// `count` vertical slabs of equal width, side by side, starting at x = `first`.
struct Slabs {
  double first = 0, width = 1;
  std::size_t count = 0;
  /// x of the left side of slab k; k = count gives the right side of the last slab.
  double line(std::size_t k) const { return first + static_cast<double>(k) * width; }
  double centre(std::size_t k) const { return first + (static_cast<double>(k) + 0.5) * width; }
};
/// The fewest slabs that cover low..high in x and are no wider than `most` (plus one millionth for rounding); at least
/// one.
Slabs slabs_over(double low, double high, double most);

/// An interval of a slab's centre line.
struct LaneInterval {
  std::size_t slab = 0;
  double low = 0, high = 0;  // y
};
struct Projection {
  std::vector<LaneInterval> intervals;  // by slab, then bottom to top; disjoint within a slab
  /// Pairs of indices into `intervals`, in neighbouring slabs, that the region connects across the line between the
  /// slabs. Sorted, unique.
  std::vector<std::pair<std::size_t, std::size_t>> links;
};
/// Projection of the set bounded by `edges` (even-odd rule). Heights that the set reaches only on the right side of a
/// slab belong to the next slab. Vertices within 1e-6 slab widths of a slab line count as on it.
/// O((n + k) log n) for n edges with k crossings of slab lines.
Projection project(const std::vector<Segment>& edges, const Slabs& slabs);

/// The parts of the vertical segment from (x, low) to (x, high) that lie in `space`, as pairs (low, high), ascending.
/// Where a wall ends a part, that end is pulled in by `margin`. Cost: the edges near the segment.
std::vector<std::pair<double, double>> clip_vertical(const EdgeIndex& space, double x, double low, double high,
                                                     double margin);

/// The parts of lanes that lie in configuration space.
struct ClippedLanes {
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::vector<LaneInterval> pieces;   // by slab, then bottom to top
  std::vector<std::size_t> piece_of;  // for each given interval its first piece; kNone: all of it is outside
};
/// Clips each interval to `space` as clip_vertical does. Pieces of one slab at most `join` metres apart become one if
/// the segment between them is free. `intervals` by slab, then bottom to top.
ClippedLanes clip_lanes(const std::vector<LaneInterval>& intervals, const Slabs& slabs, const EdgeIndex& space,
                        double join, double margin);

}  // namespace oxturn
