// An open tour over elements that can each be driven in several ways (patterns), from a given start.
//
// Source      nearest neighbour; Or-opt (Or 1976) and 2-opt (Croes 1958) over neighbour lists; the pattern of each
//             element by dynamic programming over the order (the usual treatment of generalised tours)
// Lengths are true path lengths inside configuration space; straight distance is the lower bound that saves most
// of the searches. Deterministic: effort is bounded by counts, never by the clock (except that a cancelled
// context ends it early, with the tour as good as it is then).
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/transit/connector.hpp"

namespace oxturn {

/// One way to drive an element. `reverse` is the index of the pattern that drives it backwards, from `exit` to
/// `entry`, at the same cost.
struct Pattern {
  Point entry, exit;
  double cost = 0;
  std::size_t reverse = 0;
};
using TourElement = std::vector<Pattern>;  // at least one pattern
struct TourStop {
  std::size_t element = 0, pattern = 0;
};

class OpenTour {
 public:
  /// Keeps references to all three.
  OpenTour(const Point& start, const std::vector<TourElement>& elements, const Connector& connector);
  ~OpenTour();

  /// Always to the nearest entry by path length (the 24 nearest by straight distance are looked at). About
  /// O(n log n) steps plus the path searches.
  std::vector<TourStop> nearest(Context& context) const;
  /// Depth-first walk of the graph `neighbours`: from an element to its nearest unvisited neighbour; where there
  /// is none, to the nearest unvisited neighbour of the element visited last that still has one. New roots: the
  /// nearest element.
  std::vector<TourStop> depth_first(const std::vector<std::vector<std::size_t>>& neighbours, Context& context) const;
  /// Or-opt and 2-opt moves until none helps or the effort is used up. Never longer than before.
  void improve(std::vector<TourStop>& tour, Context& context) const;
  /// The best patterns for this order. O(n p^2) path lengths.
  void choose_patterns(std::vector<TourStop>& tour) const;
  /// Transit and pattern cost of a tour.
  double cost(const std::vector<TourStop>& tour) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace oxturn
