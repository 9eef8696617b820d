/// What planners that wind spirals over cells share (bsa, linked-spiral): the option `partial`, and the move to the
/// next spiral.
///
///   struct Params : SpiralOptions {};
///   return walk_spirals(problem, context, p_, [](CellWalk& walk, WallFollower* walls) { ...; escape(walk, walls,
///   true); });
#pragma once

#include <functional>
#include <stdexcept>

#include "algorithms/grid/cell_planner.hpp"
#include "algorithms/grid/wall_follower.hpp"

namespace oxturn {

struct SpiralOptions : CellOptions {
  bool partial = false;
  void check() const {
    CellOptions::check();
    if (sensing == Sensing::lidar && partial)
      throw std::invalid_argument("partial = true needs the map; sensing = lidar goes with partial = false");
  }
};

template <class P>
std::vector<Parameter<P>> with_spiral_options(std::vector<Parameter<P>> own) {
  own.push_back(
      {"partial", &P::partial, "follow walls through cells that are not entirely free (needs sensing = map)"});
  return with_cell_options<P>(std::move(own));
}

/// As walk_cells, with a wall follower if options.partial (else nullptr); records its `along_walls_m`.
Path walk_spirals(const Problem& problem, Context& context, const SpiralOptions& options,
                  const std::function<void(CellWalk&, WallFollower*)>& walk);

/// Goes to the nearest cell beside an unvisited one. With a wall follower, unfollowed walls are goals as well and are
/// followed at once, `left`: with the wall on the left. False if no unvisited cell can be reached.
bool escape(CellWalk& walk, WallFollower* walls, bool left);

}  // namespace oxturn
