// Covers what has come to be known since the plan was made, or was planned but not driven, and is still bare.
//
// Greedy: to the nearest bare place, until what is left is not worth the way: patches under `kWorth` of a tool width
// square, or less than `kShare` of the target in all. Meant for strips along walls that were first seen from afar.
// Complexity  O(cells of the window + way), and a shortest path for each place
#pragma once

#include <optional>

#include "algorithms/online/driver.hpp"

namespace oxturn {

class Leftover {
 public:
  /// The planner has been given this; what of its target it leaves bare is its own affair.
  void planned(const Problem& believed, const Path& path);
  /// One motion over all that is bare; nullopt: nothing worth a motion.
  std::optional<Motion> next(const View& view);

 private:
  Region planned_;          // the target of the plan
  Path path_;               // the plan
  std::uint64_t seen_ = 0;  // revision of the belief at the last call
  int calls_ = 0;
};

}  // namespace oxturn
