/// Time to drive a path: trapezoidal speed profile, stops at corners, slower in curves.
///
///   const MissionClock clock(problem, path);
///   clock.total();                                   // seconds
///   clock.at(12.5);                                  // seconds until 12.5 m are driven
///
/// Model       At a corner (a change of heading above 0.3 rad that is not part of a sampled curve) the robot stops and
///             turns on the spot at turn_rate. Elsewhere it drives through, at most at turn_rate * local radius. A
///             curve tighter than min_turn_radius cannot be driven: the robot stops where it begins and where it ends,
///             and follows it at turn_rate * local radius, however finely it is sampled. The robot starts and ends at
///             rest, with the right heading. Switching the tool takes no time.
/// Method      speed limits at vertices and on segments, then a forward and a backward pass with the acceleration. O(n)
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
  /// Seconds until `path_m` metres are driven; where the robot turns on the spot, until the turn begins. O(log n).
  double at(double path_m) const;

 private:
  /// Straight from one change of heading to the next.
  struct Straight {
    double begin_m, begin_s;  // when it sets off, after turning
    double length, from_speed, to_speed, top;
  };
  double acceleration_;
  std::vector<Straight> straights_;
  double total_ = 0;
};

}  // namespace oxturn
