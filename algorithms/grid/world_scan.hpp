// MyCarbot's world scan: drive for a place outside of the world until there is no way to it any more.
//
// Source      MyCarbot (TH Nuernberg), section 2.1
// What is unknown counts as free; each refusal of a way shows more of the outer wall. When no way is left, the outer wall is
// known but for gaps that the robot does not fit through.
// Complexity  a motion O(cells of the belief's window at its coarsest level, radius / 12)
// Decisions   1. The place is far up (its pictures end at the upper wall). Any way out of the window of what has been seen
//                counts, the one nearest to that place by steps is taken.
//             2. Where the robot cannot go on although nothing is known to be in the way, half a radius ahead is taken as
//                wall from then on, so that the scan ends.
#pragma once

#include <optional>

#include "algorithms/online/driver.hpp"

namespace oxturn {

class WorldScan {
 public:
  /// Where to drive next; nullopt: the outer wall is closed.
  std::optional<Motion> next(const View& view);

 private:
  std::vector<Point> refused_;
};

}  // namespace oxturn
