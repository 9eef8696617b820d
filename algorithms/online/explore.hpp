// Exploring: to the nearest place from which some frontier can be seen, until none is left that can be reached.
//
// A frontier is a free cell next to unknown ones that no wall is near to; frontiers that touch are one. A viewpoint of
// one is a place where the robot can stand, with half of it in sight and near enough to be believed. What stays a
// frontier although it was looked at must be looked at from half as far the next time, and is given up when the robot
// has been next to it: so exploring ends.
// Decisions   1. Cells of radius / 8 and one world of that resolution (finer where the robot would not fit into it).
//             2. A frontier shorter than `least` is left to the sweep, which passes it anyway.
//             3. Frontiers beyond the tether's reach are left alone.
//             4. The nearest viewpoint is one whole motion, so the robot does not run to and fro.
// Complexity  a call O(cells of the window) and, without a tether, one shortest path
#pragma once

#include <map>
#include <utility>

#include "algorithms/online/driver.hpp"

namespace oxturn {

struct ExploreSettings {
  double least = 0;  // metres; 0: half the robot's radius
};

class Explorer {
 public:
  explicit Explorer(const ExploreSettings& settings = {}) : settings_(settings) {}
  /// The next motion; nullopt: nothing is left to see that can be reached. With a tether no motion breaks the leash.
  std::optional<Motion> next(const View& view);

 private:
  std::optional<Problem> world(const View& view, const Point& base);
  double& look_from(const BitGrid& grid, int i, int j, double farthest);
  BitGrid open_cells(const View& view, const Belief::Cells& cells);

  ExploreSettings settings_;
  int level_ = Belief::kCoarsest;
  std::map<std::pair<std::int64_t, std::int64_t>, double> look_from_;  // cell -> how near it must be looked at from
  double look_cell_ = 0;
  Point look_origin_{0, 0};
};

}  // namespace oxturn
