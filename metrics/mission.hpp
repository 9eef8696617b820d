/// Time to drive a path: limited speed, acceleration and turn rate, with rounded corners.
///
///   const MissionClock clock(problem, path);
///   clock.total();                                   // seconds
///   clock.at(12.5);                                  // seconds until 12.5 m are driven
///
/// Model       The robot drives the path smoothed over a tenth of the tool width (smooth_path.hpp): each corner is
///             rounded within a fifth of the tool width, straight parts are exact. Its speed is at most `speed`, and
///             `turn_rate` times the radius of curvature. Where the curve turns back on itself the robot turns on the
///             spot. It accelerates and brakes at most at `acceleration`, and starts and ends at rest, with the right
///             heading. In a curve tighter than min_turn_radius, the change of heading beyond that of a curve with this
///             radius is made up at rest, at turn_rate. Switching the tool takes no time. To change gear it stops, and
///             turns to the new heading if that is another one.
/// Guarantee   Continuous in the path: cutting a corner into many small ones or moving a vertex by a millimetre changes
///             the time by as little, and points on a straight line change nothing.
/// Method      The curve is sampled near bends only, more finely where it turns more. From the speed limits at the
///             samples drive_times.hpp makes times. Accurate to 1e-3. O(n)
#pragma once

#include "geometry/path.hpp"
#include "maps/problem.hpp"
#include "metrics/drive_times.hpp"

namespace oxturn {

class MissionClock {
 public:
  MissionClock(const Problem& problem, const Path& path);
  /// Seconds until the end.
  double total() const { return times_.total(); }
  /// Seconds until `path_m` metres of the path are driven. Monotone. O(log n).
  double at(double path_m) const { return times_.at(path_m); }

 private:
  class Sampler;
  DriveTimes times_;
};

}  // namespace oxturn
