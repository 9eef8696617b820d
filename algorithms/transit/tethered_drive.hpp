/// A path that leads from point to point by tethered shortest paths, whatever the order of the points.
///
///   TetheredDrive drive(space, {});
///   for (const Point& p : points) if (!drive.go(p)) miss(p);
///   return drive.take();
///
/// The plain shortest path is taken where the tether is long enough for it, else the shortest in another homotopy
/// class. The tether may wind around obstacles, as long as it keeps its length limit.
///
/// Complexity  a path costs that of TetheredRobot::path_to(); no simulation of the tether is needed as long as the
///             tether and the path together are not longer than the limit
#pragma once

#include "algorithms/transit/tether_space.hpp"
#include "geometry/path.hpp"

namespace oxturn {

class TetheredDrive {
 public:
  struct Settings {
    Retraction retraction = Retraction::automatic;
    std::size_t budget = 2000;  // expansions per path, of the search in other homotopy classes
  };
  /// From the problem's start. `space` must outlive it.
  TetheredDrive(const TetherSpace& space, Settings settings);

  const Point& at() const { return robot_.at(); }
  /// To `goal`, with the tool on. False if no path keeps the tether length limit: then the robot stays where it is. If
  /// the path driven so far, pulled taut, is longer than three tethers, the robot goes home along it first.
  bool go(const Point& goal);
  /// To one point after the other. Returns how many could not be reached.
  std::size_t go_along(const Polyline& points);
  /// Back to the start with the tool off, the tether taken in.
  void go_home();
  /// Paths that may not be the shortest, because the search's budget ran out.
  std::size_t unproven() const { return unproven_; }
  const Path& path() const { return path_.path(); }
  Path take() { return path_.take(); }

 private:
  void unwind();

  const TetherSpace& space_;
  Settings settings_;
  TetheredRobot robot_;
  PathBuilder path_;
  std::size_t unproven_ = 0;
};

}  // namespace oxturn
