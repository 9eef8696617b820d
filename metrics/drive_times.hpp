/// When a robot passes the points of a curve, from the limits of its speed there.
///
///   DriveTimes times(robot, 0.2);
///   times.add({.path_m = 0, .limit = 0.5, .length = 3, .at_rest = true});   // then 3 m straight ahead
///   times.add({.path_m = 3, .limit = 0.5, .at_rest = true});
///   times.finish();
///   times.at(1.5);                                                          // seconds
///
/// Method      The robot accelerates and brakes at `acceleration`: a forward pass over the samples limits the speed by
///             what lies behind, a backward pass by what lies ahead. No sample counts for those that are farther behind
///             than the robot needs to brake to a stop. So the passes run over a window of samples, and only times are
///             kept, of stretches of at least `step` metres where the samples are closer.
/// Complexity  O(n) time. Memory: O(length / step), and the samples within a braking distance
#pragma once

#include <cstddef>
#include <deque>
#include <vector>

#include "maps/robot.hpp"

namespace oxturn {

class DriveTimes {
 public:
  /// `step`: metres; in between, times are interpolated.
  DriveTimes(const Robot& robot, double step);

  /// A sample of the curve, and what lies between it and the next one.
  struct Sample {
    double path_m = 0;     // of the path until there
    double limit = 0;      // of the speed
    double length = 0;     // of the curve until the next sample, metres
    double turn = 0;       // absolute change of heading until the next sample, radians
    bool at_rest = false;  // the robot stops there, or starts
  };
  void add(const Sample& sample);
  /// What the robot turns at the last sample, where it is at rest.
  void turn_at_rest(double turn) { pending_.back().turn = turn; }
  /// After the last sample.
  void finish();

  /// Seconds until the end.
  double total() const { return total_; }
  /// Seconds until `path_m` metres of the path are driven. Monotone. O(log n).
  double at(double path_m) const;

 private:
  struct Pending {
    double path_m, length, turn;
    double speed;  // at the sample
    double top;    // the greatest until the next sample, once that is known
  };
  /// With the greatest acceleration up to `top` and down again; if its length is 0, with a constant one.
  struct Stretch {
    double path_m, begin_s;  // at its begin
    double length, from, to, top;
  };
  void brake();
  std::size_t last_settled() const;
  void pass_until(std::size_t end);
  void keep(const Pending& here, const Pending& next);

  double acceleration_, turn_rate_, min_turn_radius_, step_;
  std::vector<Pending> pending_;  // their speeds may still become lower, by samples to come
  std::size_t room_;              // of pending_, until some are settled
  bool joins_ = false;            // may the next samples belong to the last stretch?
  std::deque<Stretch> stretches_;
  double total_ = 0;
};

}  // namespace oxturn
