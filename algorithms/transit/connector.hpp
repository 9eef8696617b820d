// How to get from one place to another inside configuration space: straight if that is free, else the shortest
// path (problem.transit()). One place for it, so that no planner ever goes straight through a wall.
#pragma once

#include <limits>
#include <optional>

#include "maps/problem.hpp"

namespace oxturn {

class Connector {
 public:
  /// `problem` must outlive it. Builds the problem's edge index and triangulation if they are not there yet.
  explicit Connector(const Problem& problem);

  /// From a to b, both included. Throws std::runtime_error naming both places if they are not connected, which
  /// happens only if one of them is outside configuration space by more than the problem's tolerance.
  Polyline path(const Point& a, const Point& b) const;
  /// Its length; infinity if it is longer than `longest`. Straight ones cost one exact segment test.
  double length(const Point& a, const Point& b, double longest = std::numeric_limits<double>::infinity()) const;
  /// The closed segment stays in configuration space, exactly.
  bool straight(const Point& a, const Point& b) const;

 private:
  const EdgeIndex& walls_;
  const ShortestPaths& paths_;
};

}  // namespace oxturn
