// Drives a robot through a world that it only learns by lidar: simulates motion and scans, and keeps the belief.
// An online planner is a Policy, which is asked where to go next, or a function that drives an OnlineRobot.
//
// The robot scans at its start, every `scan_step` metres and at the end of every motion, but no place twice (with noise
// ten times): the world stands still. Its pose is known exactly.
// Before each stretch is driven it is checked against the newest belief; where the belief blocks what is left of a
// motion, the robot stops there and the planner has to think again (a re-plan); it may always go straight back to the
// point that it came from. A leash stops it where it is pulled tight. Nothing of the true map is reachable from it: it
// gets a View, which is made of scans.
#pragma once

#include <functional>
#include <optional>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/online/belief.hpp"

namespace oxturn {

class Drive;

/// All that a planner may know.
class View {
 public:
  View(Robot robot, const Point& start, const Point& anchor)
      : robot_(std::move(robot)), start_(start), anchor_(anchor), pose_(start), belief_(robot_, start) {}

  const Robot& robot() const { return robot_; }
  const Point& start() const { return start_; }
  const Point& anchor() const { return anchor_; }  // of the tether; the start if there is none
  /// A robot on a leash knows how its line lies at the start: a way for it along that line, from the start to the place
  /// nearest to the anchor. Empty if that is the start.
  const Polyline& line() const { return line_; }
  const Point& pose() const { return pose_; }
  const Belief& belief() const { return belief_; }
  /// What has been driven so far.
  const Path& path() const { return path_; }
  Polyline way() const;                      // its points, from the start to the pose
  double driven() const { return driven_; }  // metres
  /// The last motion was stopped before its end.
  bool stopped() const { return stopped_; }
  /// How many points of the last motion were reached.
  std::size_t reached() const { return reached_; }

 private:
  friend class Drive;
  Robot robot_;
  Point start_, anchor_, pose_;
  Polyline line_;
  Belief belief_;
  Path path_;
  double driven_ = 0;
  bool stopped_ = false;
  std::size_t reached_ = 0;
};

struct Motion {
  Polyline points;  // a first point equal to the pose is skipped
  bool tool = true;
};

class Policy {
 public:
  virtual ~Policy() = default;
  /// Where to go next; nullopt: done.
  virtual std::optional<Motion> next(const View& view, Context& context) = 0;
};

struct OnlineSettings {
  double scan_step = 0;  // metres between scans; 0: the robot's radius (half its tool's width if it has none)
};

/// What a program steers: sees what a policy sees, and goes.
class OnlineRobot {
 public:
  const View& view() const;
  /// Drives the motion, scanning on the way. False if it was stopped before its end: by what has come to be believed,
  /// or because the run is cancelled.
  bool go(const Motion& motion);

 private:
  friend class Drive;
  explicit OnlineRobot(Drive& drive) : drive_(drive) {}
  Drive& drive_;
};

/// Runs the program until it returns; when cancelled the robot goes nowhere any more, and the program should return.
/// Publishes what has been driven, as often as it has grown by a fiftieth, and reports `explored_share` (the part of the
/// true target that is believed free), `replans` and `scans`. Throws Unsupported for a robot without a lidar, Infeasible
/// if it never moved.
Path drive_online(const Problem& truth, const std::function<void(OnlineRobot&, Context&)>& program, Context& context,
                  const OnlineSettings& settings = {});
/// The same, asking a policy. Ends also when three motions in a row cannot even begin.
Path drive_online(const Problem& truth, Policy& policy, Context& context, const OnlineSettings& settings = {});

/// The world as believed, at a belief's level (belief.hpp), as a problem to plan on. It starts at `start`, or, where
/// the believed walls are too near for that, at the nearest place within a few cells (`drive_online` lets the robot go
/// there). The anchor is moved likewise and the tether shortened by as much. nullopt if the robot fits nowhere near.
std::optional<Problem> believed_problem(const View& view, const Point& start, int level);

}  // namespace oxturn
