/// The tether along many paths that begin alike: the segments that they share are driven once.
///
///   TetherTree tethers(tether, longest);
///   for (const Polyline& path : paths) if (tethers.stays_within(path)) return path;
///
/// O(segments that no earlier path began with) drives of a tether. Keeps 2,000 tethers at most.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include "geometry/tether/taut_tether.hpp"

namespace oxturn {

class TetherTree {
 public:
  /// From where the tether is; `longest` metres are its limit.
  TetherTree(const TautTether& tether, double longest) : root_{.tether = tether}, longest_(longest) {}

  /// Does the tether keep its limit along `points`, which begin where its robot is? It is longest at one of them.
  bool stays_within(const Polyline& points);

 private:
  static constexpr std::size_t kMost = 2000;
  struct Node {
    TautTether tether;
    std::vector<Node*> next;
    bool too_long = false;
  };
  /// The same driven on to `to`; nullptr: too many are kept.
  Node* next(Node& node, const Point& to);

  Node root_;
  std::deque<Node> nodes_;
  double longest_;
};

}  // namespace oxturn
