// Ways in the believed world, for robots with and without a tether.
//
// Without: the shortest path. With: the shortest path if the string stays within the leash all along it, else back along
// the way driven as far as is needed and from there. The string is simulated in the believed map, along the whole way
// driven: believed free space is a part of the true one, so the true string is never longer.
// Complexity  a question O(n log n) for n points driven so far and the path; up to kTurns times that if the leash is in
//             the way
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "algorithms/online/driver.hpp"

namespace oxturn {

class StringWays {
 public:
  /// `believed` as believed_problem makes it (tethered: with the view's start); it must outlive this. `way`: driven so
  /// far, from the view's start.
  StringWays(const Problem& believed, Polyline way);
  ~StringWays();

  const Problem& problem() const { return believed_; }
  /// From the robot's place to `goal` in configuration space, both included; the first stretch may lead from a place
  /// just outside of it. nullopt if there is none.
  std::optional<Polyline> to(const Point& goal) const;
  /// To where the way began; at its end the string lies as it did then. Always possible with a tether, where the way back
  /// is one; nullopt without if there is no path.
  std::optional<Polyline> home() const;
  /// The string stays within the leash along these points, driven from the robot's place (always, without a tether).
  bool holds(const Polyline& points) const;

 private:
  struct Strings;
  std::optional<Polyline> path(const Point& from, const Point& to) const;

  const Problem& believed_;
  Polyline way_;
  std::unique_ptr<Strings> strings_;
};

}  // namespace oxturn
