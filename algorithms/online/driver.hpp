// Drives a robot through a world that it only learns by lidar: simulates motion and scans, keeps the belief, asks a
// policy where to go next. Any online planner is a Policy.
//
// The robot scans at its start, every `scan_step` metres and at the end of every motion, but no place twice (with noise
// ten times): the world stands still. Its pose is known exactly.
// Before each stretch is driven it is checked against the newest belief; where the belief blocks what is left of a
// motion, the robot stops there and the policy is asked again (a re-plan). Nothing of the true map is reachable from
// a policy: it gets a View, which is made of scans.
#pragma once

#include <memory>
#include <optional>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/online/belief.hpp"

namespace oxturn {

/// All that a policy may know.
class View {
 public:
  View(Robot robot, const Point& start, const Point& anchor)
      : robot_(std::move(robot)), start_(start), anchor_(anchor), pose_(start), belief_(robot_, start) {}

  const Robot& robot() const { return robot_; }
  const Point& start() const { return start_; }
  const Point& anchor() const { return anchor_; }  // of the tether; the start if there is none
  const Point& pose() const { return pose_; }
  const Belief& belief() const { return belief_; }
  /// What has been driven so far.
  const Path& path() const { return path_; }
  Polyline way() const;  // its points, from the start to the pose
  /// The last motion was stopped before its end.
  bool stopped() const { return stopped_; }
  /// How many points of the last motion were reached.
  std::size_t reached() const { return reached_; }

 private:
  friend class Drive;
  Robot robot_;
  Point start_, anchor_, pose_;
  Belief belief_;
  Path path_;
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

/// Ends when the policy does, when cancelled, or when three motions in a row cannot even begin. Publishes what has been
/// driven at the end of every motion, and reports `explored_share` (the part of the true target that is believed free)
/// and `replans`. Throws Unsupported for a robot without a lidar, Infeasible if it cannot move at all.
Path drive_online(const Problem& truth, Policy& policy, Context& context, const OnlineSettings& settings = {});

/// The world as believed, at a belief's level (belief.hpp), as a problem to plan on. It starts at `start`, or, where
/// the believed walls are too near for that, at the nearest place within a few cells (`drive_online` lets the robot go
/// there). The anchor is moved likewise and the tether shortened by as much. nullopt if the robot fits nowhere near.
std::optional<Problem> believed_problem(const View& view, const Point& start, int level);

}  // namespace oxturn
