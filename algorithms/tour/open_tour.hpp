/// An open tour from a given start over elements, each of which can be driven in several patterns.
///
///   OpenTour tours(start, elements, connector);
///   std::vector<TourStop> tour = tours.nearest(context);
///   tours.improve(tour, context);
///
/// Nearest neighbour; Or-opt (Or 1976) and 2-opt (Croes 1958) over neighbour lists; the pattern of each element by
/// dynamic programming along the order, as is usual for generalised tours.
/// Costs are lengths of paths inside configuration space. Straight distance is their lower bound, which saves most of
/// the searches. Deterministic: the effort is limited by counts, never by the clock (a cancelled context ends it early,
/// with the tour as good as it is by then).
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "algorithms/coverage_planner.hpp"
#include "algorithms/transit/connector.hpp"

namespace oxturn {

/// How an element can be driven. `reverse` is the index of the pattern that drives it backwards, from `exit` to
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

class TourCosts;

class OpenTour {
 public:
  /// Keeps references to `elements` and `connector`.
  OpenTour(const Point& start, const std::vector<TourElement>& elements, const Connector& connector);
  ~OpenTour();

  /// Always to the nearest entry by path length; only the 24 nearest by straight distance are considered.
  /// About O(n log n) steps besides the path searches.
  std::vector<TourStop> nearest(Context& context) const;
  /// Depth-first over the graph `neighbours`: from an element to its nearest unvisited neighbour; if there is none, to
  /// the nearest unvisited neighbour of the element visited last that still has one; else to the nearest element.
  std::vector<TourStop> depth_first(const std::vector<std::vector<std::size_t>>& neighbours, Context& context) const;
  /// Or-opt and 2-opt moves until none helps or the effort is spent. Never longer than before.
  void improve(std::vector<TourStop>& tour, Context& context) const;
  /// The best patterns for this order. O(n p^2) path lengths for p patterns an element.
  void choose_patterns(std::vector<TourStop>& tour) const;
  /// Lengths of the paths between the elements, and costs of their patterns.
  double cost(const std::vector<TourStop>& tour) const;

 private:
  std::unique_ptr<const TourCosts> costs_;
};

}  // namespace oxturn
