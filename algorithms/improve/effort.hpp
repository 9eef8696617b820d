/// What improvement has done, in counts that are the same on every machine.
///
///   effort += now.effort;
///   context.record("annealing_moves", effort.moves);
///
/// Time goes into moves, into rasters of witnesses and into measuring what paths leave uncovered: the sum of these,
/// each with its constant.
#pragma once

namespace oxturn {

struct Effort {
  double moves = 0;          // of annealing that were tried
  double raster_points = 0;  // of witnesses that were set up
  double vertices = 0;       // of paths of which it was measured what they leave uncovered

  Effort& operator+=(const Effort& more) {
    moves += more.moves;
    raster_points += more.raster_points;
    vertices += more.vertices;
    return *this;
  }
};

}  // namespace oxturn
