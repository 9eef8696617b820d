/// Covers what has become known since the plan was made, or was planned but not driven, and is still uncovered.
///
///   Leftover leftover;
///   leftover.planned(believed, path);
///   while (auto motion = leftover.next(view)) ...
///
/// Greedy: to the nearest uncovered point, until what is left is not worth the path: connected components of less than
/// 1/64 of a tool width square, or less than 1/2000 of the target altogether. Meant for strips along walls that were
/// first seen from afar.
/// O(cells of the window + path), and a shortest path for each point.
#pragma once

#include <optional>

#include "algorithms/online/driver.hpp"

namespace oxturn {

class Leftover {
 public:
  /// The planner was given this problem; what it leaves uncovered of its target is its own decision.
  void planned(const Problem& believed, const Path& path);
  /// One motion over all that is uncovered; nullopt: nothing is worth a motion.
  std::optional<Motion> next(const View& view);

 private:
  BitGrid uncovered_cells(const View& view, const Problem& believed) const;
  Polyline tour(const View& view, const Problem& believed, BitGrid& uncovered);

  Region planned_;          // the target of the plan
  Path path_;               // the plan
  std::uint64_t seen_ = 0;  // revision of the belief at the last call
  int calls_ = 0;
};

}  // namespace oxturn
