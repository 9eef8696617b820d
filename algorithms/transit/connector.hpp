/// Paths between two points of configuration space: straight if possible, else the shortest path.
///
///   const Connector connector(problem);
///   path.drive(connector.path(path.at(), next), false);
///
/// Planners that connect points go through this class, so none of them drives straight through a wall.
/// A straight connection costs one exact segment test, others a shortest-path query.
#pragma once

#include <limits>
#include <optional>

#include "maps/problem.hpp"

namespace oxturn {

class Connector {
 public:
  /// `problem` must outlive it. Builds the problem's edge index and triangulation if they do not exist yet.
  explicit Connector(const Problem& problem);

  /// From a to b, both included. Throws std::runtime_error with both points if they are not connected, which happens
  /// only if one of them is outside configuration space by more than the problem's tolerance.
  Polyline path(const Point& a, const Point& b) const;
  /// The length of that path; infinity if it is longer than `longest`.
  double length(const Point& a, const Point& b, double longest = std::numeric_limits<double>::infinity()) const;
  /// The closed segment lies in configuration space, exactly.
  bool straight(const Point& a, const Point& b) const;

 private:
  const EdgeIndex& walls_;
  const ShortestPaths& paths_;
};

}  // namespace oxturn
