// Parallel lanes: a turned frame in which they are vertical, and what of a region falls into which slab.
//
// The plane is cut into slabs of one width; each has a centre line. The lane of a region in a slab is the
// projection of (region n slab) to the centre line. A tool as wide as the slab that drives it passes over every
// point of the region at the point's own height, however the boundary runs inside the slab: nothing is sampled.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "geometry/edge_index.hpp"
#include "geometry/region.hpp"
#include "maps/problem.hpp"

namespace oxturn {

/// Turns the plane so that lanes of the given direction (degrees, counter-clockwise from +x) become vertical.
/// Quarter turns are exact.
class Frame {
 public:
  explicit Frame(double lane_degrees);
  Point to(const Point& p) const { return {c_ * p.x() - s_ * p.y(), s_ * p.x() + c_ * p.y()}; }
  Point back(const Point& p) const { return {c_ * p.x() + s_ * p.y(), c_ * p.y() - s_ * p.x()}; }
  Region to(const Region& region) const;

 private:
  double c_, s_;
};

/// A superset of the points of configuration space C at least `inset` from its boundary, and hardly more: what
/// lanes must cover if the boundary itself is driven. Made from the map in one step (radius + inset), since eroding C
/// again would round every corner twice. Round corners are chords up to `chord` too far out, and never leave C.
Region lane_region(const Problem& problem, double inset, double chord);

struct Segment {
  Point a, b;
};
void add_ring(std::vector<Segment>& edges, const Ring& ring);
std::vector<Segment> edges_of(const Region& region);

/// `count` slabs of width `width`, side by side, from `first` on.
struct Slabs {
  double first = 0, width = 1;
  std::size_t count = 0;
  double line(std::size_t k) const { return first + static_cast<double>(k) * width; }
  double centre(std::size_t k) const { return first + (static_cast<double>(k) + 0.5) * width; }
};
/// The fewest slabs no wider than `most` (and a millionth, for rounding) over the x-range low..high; at least one.
Slabs slabs_over(double low, double high, double most);

/// A piece of a slab's centre line.
struct Stretch {
  std::size_t slab = 0;
  double low = 0, high = 0;
};
struct Projection {
  std::vector<Stretch> stretches;                          // by slab, then bottom to top; disjoint in a slab
  std::vector<std::pair<std::size_t, std::size_t>> links;  // stretches of neighbouring slabs that the region
                                                           // itself joins across the line between; sorted, unique
};
/// Projection of the set that `edges` bound (even-odd). Heights that a slab has on its border line alone do not count:
/// they are the neighbour's. Edges within 1e-6 widths of a line count as on it. O((n + k) log n), k = crossings of edges with slab lines.
Projection project(const std::vector<Segment>& edges, const Slabs& slabs);

/// The parts of the vertical segment x, low..high that lie in `room`, ends pulled in by `margin` where a wall
/// stops them. Costs what the segment's surroundings hold.
std::vector<std::pair<double, double>> clip_vertical(const EdgeIndex& room, double x, double low, double high,
                                                     double margin);

/// The same for stretches of slabs; pieces of one slab no more than `join` apart become one if the line between
/// them is free. `source[i]` is the stretch that piece i comes from (the first, if several were joined).
struct Clipped {
  std::vector<Stretch> pieces;
  std::vector<std::size_t> source;
  std::vector<std::size_t> piece_of;  // for every stretch its first piece, or kNone if nothing is left of it
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
};
/// `stretches` by slab, then bottom to top.
Clipped clip(const std::vector<Stretch>& stretches, const Slabs& slabs, const EdgeIndex& room, double join,
             double margin);

}  // namespace oxturn
