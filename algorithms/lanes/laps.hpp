/// Laps parallel to the boundary of configuration space, level by level inwards.
///
///   const Laps laps = laps_of(problem, tool_width, context);
///   for (const Lap& lap : laps.all) path.drive(lap.ring, true);
///
/// Laps are boundaries of erosions of configuration space (straightened_space() in outline.hpp), holes included. Each
/// is made from the one before it. Vertices of arcs are left out where a lap moves by less than a hundredth of the
/// tool's width; laps are nearer to each other by as much. O(m log m) for laps with m vertices in all.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "algorithms/context.hpp"
#include "geometry/point_grid.hpp"
#include "maps/problem.hpp"

namespace oxturn {

struct Lap {
  Ring ring;
  std::vector<std::size_t> inner = {};  // laps of the next level that are nearer to this one than to others
};

/// Level by level; the first `outermost` are of level 0.
struct Laps {
  std::vector<Lap> all;
  std::size_t outermost = 0;
  Region between = {};  // what closed laps leave uncovered between each other
  double depth_m = 0;   // from the boundary of configuration space: so far laps cover everything but `between`
};

/// `spacing` in metres. Ends early if cancelled.
Laps laps_of(const Problem& problem, double spacing, const Context& context,
             int levels = std::numeric_limits<int>::max());
/// All of them without `between`, in two thirds of the time.
Laps laps_alone(const Problem& problem, double spacing, const Context& context);

/// The vertex of a ring that is nearest to a point.
std::size_t nearest_vertex(const Ring& ring, const Point& p);

/// Links between laps up to this many tool widths long are driven with the tool on.
inline constexpr double kLongestLinkOn = 2;

/// Once around a ring, from vertex `entry` back to it.
Polyline lap_from(const Ring& ring, std::size_t entry);

/// Rings that are taken one by one, always the one with the nearest vertex. O(v log v) for all v vertices together.
class NearestRing {
 public:
  explicit NearestRing(const std::vector<const Ring*>& rings);
  bool empty() const { return vertices_.remaining() == 0; }
  /// Its index. Not empty.
  std::size_t take(const Point& p);

 private:
  std::vector<std::size_t> ring_of_, first_;  // by vertex; by ring, its first vertex
  PointGrid vertices_;
};

}  // namespace oxturn
