// Time to drive a path: trapezoidal speed profile, stops at corners, slower in curves.
//
// Model       At a corner (a change above 0.3 rad that is no part of a sampled curve) the robot stops and turns on
//             the spot at turn_rate. Elsewhere it drives through, at most at turn_rate * local radius. A curve
//             tighter than min_turn_radius cannot be driven: the robot stops where it begins and where it ends and
//             goes along it at turn_rate * local radius, however finely it is sampled. It starts and ends at rest,
//             facing the right way. The tool takes no time to switch.
// Method      Speed limits per vertex and segment, a forward and a backward pass with the acceleration. O(n).
#pragma once

#include <vector>

#include "geometry/path.hpp"
#include "maps/problem.hpp"

namespace oxturn {

class MissionClock {
 public:
  MissionClock(const Problem& problem, const Path& path);
  /// Seconds until the end.
  double total() const { return total_; }
  /// Seconds until `path_m` metres are driven; before turning, where the robot turns on the spot. O(log n).
  double at(double path_m) const;

 private:
  /// Straight on from one change of heading to the next.
  struct Stretch {
    double begin_m, begin_s;  // when it sets off: after turning
    double length, from_speed, to_speed, top;
  };
  double acceleration_;
  std::vector<Stretch> stretches_;
  double total_ = 0;
};

}  // namespace oxturn
