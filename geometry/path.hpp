/// A coverage path, as planners return it: legs in driving order, with the tool on or off.
///
///   PathBuilder path(start);
///   path.drive(lane, true);                     // work
///   path.drive(next_lane.front(), false);       // transit
///   return path.take();
#pragma once

#include "geometry/point.hpp"

namespace oxturn {

/// In reverse the robot drives backwards: its heading is opposite to its motion. A change of gear is a stop.
enum class Gear { forward, reverse };

struct Leg {
  bool tool = true;  // on: work; off: transit
  Polyline points;   // at least two; the first is the last of the previous leg
  Gear gear = Gear::forward;
  double width = 0;  // metres of the tool that are used; 0: all of it. Drawing robots use less for thin strokes
};

struct Path {
  std::vector<Leg> legs;
  /// Metres.
  double length() const;
  /// Metres driven with the tool on or off.
  double length(bool tool) const;
};

/// Builds a well-formed Path: drops repeated points and merges consecutive legs of the same kind. A point repeats the
/// one before also if they differ by rounding alone (1e-12 of the coordinates), as where the end of a lane was computed
/// from one side and the beginning of the next path from the other. Points in the middle of a straight line are kept.
class PathBuilder {
 public:
  explicit PathBuilder(const Point& start) : at_(start) {}
  /// Where the path ends.
  const Point& at() const { return at_; }
  /// Appends `points` to the path; a first point that repeats its end is dropped.
  void drive(const Polyline& points, bool tool, Gear gear = Gear::forward, double width = 0);
  /// Moves the points where they become a leg of their own.
  void drive(Polyline&& points, bool tool, Gear gear = Gear::forward, double width = 0);
  void drive(const Point& to, bool tool, Gear gear = Gear::forward) { drive(Polyline{to}, tool, gear); }
  const Path& path() const { return path_; }
  Path take() { return std::move(path_); }

 private:
  bool goes_on(bool tool, Gear gear, double width) const;

  Point at_;
  Path path_;
};

}  // namespace oxturn
