/// Paths in the believed world, for robots with and without a tether.
///
///   const BelievedPaths paths(believed, view.path_from_base());
///   if (auto path = paths.to(goal)) robot.go({*path, true});
///
/// Without a tether: the shortest path. With one: the shortest path if the tether stays within its length all along,
/// else the shortest of those that first go back along the path driven, pulled taut in the robot's space. The tether is
/// simulated in the believed map, along the whole path driven. Believed free space is a part of the true one, so the
/// true tether is never longer.
/// O(n log n) for n points driven so far and vertices; a query one shortest path, and up to kTurns of them and a pass
/// over the path driven if the tether does not allow that path.
#pragma once

#include <memory>
#include <optional>

#include "algorithms/online/driver.hpp"

namespace oxturn {

class BelievedPaths {
 public:
  /// `believed` as made by believed_problem (with a tether: with the view's start); it must outlive this. `driven`: the
  /// path so far, from the view's start. It may lie outside the present configuration space by a few cells.
  BelievedPaths(const Problem& believed, const Polyline& driven);
  ~BelievedPaths();

  /// From the robot to `goal` in configuration space, both included. The first segment may begin just outside of that
  /// space. nullopt if there is no path.
  std::optional<Polyline> to(const Point& goal) const;
  /// To where the driven path began; at the end the tether lies as it did then. With a tether always possible, by the
  /// path driven; without: nullopt if there is no path.
  std::optional<Polyline> home() const;
  /// The tether stays within its length along these points, driven from where the robot is. True without a tether.
  bool within_tether(const Polyline& points) const;

 private:
  struct Tether;
  std::optional<Polyline> path(const Point& from, const Point& to) const;
  std::optional<Polyline> path_turning_back(const Point& goal) const;
  Point inside(const Point& p) const;

  const Problem& believed_;
  Polyline driven_;
  std::unique_ptr<Tether> tether_;
};

}  // namespace oxturn
