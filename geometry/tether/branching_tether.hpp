/// The tether along many paths that begin alike: the segments that they share are driven once.
///
///   BranchingTether branches(tether, longest);
///   for (const Polyline& path : paths) if (branches.stays_within(path)) return path;
///
/// Drives a tether once along each segment that several paths have after the same beginning. Keeps 2,000 tethers at
/// most.
#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <vector>

#include "geometry/tether/taut_tether.hpp"

namespace oxturn {

/// Does a tether keep to `longest` metres while its robot drives to one point after the other? It is longest at one of
/// them.
bool stays_within(TautTether tether, std::span<const Point> points, double longest);

class BranchingTether {
 public:
  /// From where the tether is; `longest` metres are its limit.
  BranchingTether(const TautTether& tether, double longest) : root_{.tether = tether}, longest_(longest) {}

  /// Does the tether keep its limit along `points`, which begin where its robot is? It is longest at one of them.
  bool stays_within(const Polyline& points);

 private:
  static constexpr std::size_t kMost = 2000;
  struct Node {
    TautTether tether;
    std::vector<Node*> next = {};
    bool too_long = false;
  };
  /// The same driven on to `to`; nullptr: too many are kept.
  Node* next(Node& node, const Point& to);

  Node root_;
  std::deque<Node> nodes_;
  double longest_;
};

}  // namespace oxturn
