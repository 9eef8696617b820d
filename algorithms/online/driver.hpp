/// Drives a robot through a world that it only learns by lidar: simulates motion and scans, and keeps the belief. An
/// online planner is a program: a function that drives an OnlineRobot.
///
///   return drive_online(problem, [&](OnlineRobot& robot, Context&) {
///     while (const auto motion = explorer.next(robot.view())) robot.go(*motion);
///   }, context);
///
/// The robot scans at its start, each time it has driven its radius (half its tool's width if it has none), and at the
/// end of every motion, but nowhere twice (with noise ten times), because the world does not change. Its pose is known
/// exactly.
/// Each piece of a motion is checked against the newest belief before it is driven. Where the belief blocks the rest of
/// a motion, the robot stops and the planner must plan anew; going straight back to the point that it came from is
/// always allowed. A tether stops the robot where it is pulled tight. Nothing of the true map can be reached: planners
/// get a View, which is made of scans.
#pragma once

#include <functional>
#include <optional>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/online/belief.hpp"

namespace oxturn {

/// All that a planner may know.
struct View {
  View(Robot robot_, const Point& start_, const Point& anchor_)
      : robot(std::move(robot_)), start(start_), anchor(anchor_), pose(start_), belief(robot, start_) {}

  Robot robot;
  Point start, anchor;  // anchor: of the tether; the start without one
  /// A tethered robot knows how its tether lies at the start: a path for it along the tether, from the start to the
  /// point nearest to the anchor. Empty if that is the start.
  Polyline path_along_tether;
  Point pose;
  Belief belief;
  Path path;                // driven so far
  double driven = 0;        // metres
  std::size_t reached = 0;  // how many points of the last motion were reached

  /// Where planning begins: at the pose, or with a tether at the start, where it is known how the tether lies.
  const Point& base() const { return robot.tether ? start : pose; }
  /// The driven path from the base to the pose.
  Polyline path_from_base() const { return robot.tether ? path_from_start() : Polyline{pose}; }
  /// The driven path from the start to the pose.
  Polyline path_from_start() const;
};

struct Motion {
  Polyline points;  // a first point equal to the pose is skipped
  bool tool = true;
};

class OnlineRobot {
 public:
  virtual ~OnlineRobot() = default;
  virtual const View& view() const = 0;
  /// Drives the motion and scans on the way. False if it was stopped before its end, by what has come to be believed or
  /// because the run is cancelled.
  virtual bool go(const Motion& motion) = 0;
};

/// Runs the program until it returns. When cancelled, the robot does not move any more, and the program should return.
/// Publishes what has been driven whenever it has grown by a fiftieth; records `explored_share` (the part of the true
/// target that is believed free), `replans` and `scans`. Throws Unsupported for a robot without a lidar, Infeasible if
/// it never moved.
Path drive_online(const Problem& truth, const std::function<void(OnlineRobot&, Context&)>& program, Context& context);

/// The world as believed, at a level of the belief (belief.hpp), as a problem to plan on. It starts at `start`, or,
/// where the believed walls are too near for that, at the nearest possible point within a few cells (drive_online
/// allows the robot to go there). The anchor is moved likewise, and the tether shortened by as much. nullopt if the
/// robot does not fit.
std::optional<Problem> believed_problem(const View& view, const Point& start, int level);

}  // namespace oxturn
