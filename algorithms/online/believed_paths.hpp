// Ways in the believed world, for robots with and without a tether.
//
// Without: the shortest path. With: the shortest path if the string stays within the leash all along it, else the
// shortest of those that go back along the way driven as far as is needed and from there on, pulled taut in the robot's
// space. The string is simulated in the believed map, along the whole way driven: believed free space is a part of the
// true one, so the true string is never longer.
// Complexity  O(n log n) for n points driven so far and corners; a question a shortest path, and up to kTurns times that
//             and a walk over the way driven if the leash is in the way
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "algorithms/online/driver.hpp"

namespace oxturn {

class BelievedPaths {
 public:
  /// `believed` as believed_problem makes it (tethered: with the view's start); it must outlive this. `way`: driven so
  /// far, from the view's start. It may lie outside of the newest configuration space by a few cells.
  BelievedPaths(const Problem& believed, const Polyline& way);
  ~BelievedPaths();

  /// From the robot's place to `goal` in configuration space, both included; the first stretch may lead from a place
  /// just outside of it. nullopt if there is none.
  std::optional<Polyline> to(const Point& goal) const;
  /// To where the way began; at its end the string lies as it did then. With a tether always possible: the way back is
  /// one. Without: nullopt if there is no path.
  std::optional<Polyline> home() const;
  /// The string stays within the leash along these points, driven from the robot's place (always, without a tether).
  bool holds(const Polyline& points) const;

 private:
  struct Strings;
  std::optional<Polyline> path(const Point& from, const Point& to) const;
  Point inside(const Point& p) const;

  const Problem& believed_;
  Polyline driven_;  // as it was
  std::unique_ptr<Strings> strings_;
};

}  // namespace oxturn
