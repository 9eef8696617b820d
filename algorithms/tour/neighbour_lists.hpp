/// For each pattern the elements that are cheapest to go to, and those cheapest to come from.
///
///   const NeighbourLists lists(problem, 8);
///   for (const Neighbour& n : lists.after(p)) { /* n.cost = the least cost from p to a pattern of n.element */ }
///
/// Moves look at these connections only: a tour's good connections are almost always among the cheapest few.
/// Build: one cost for each pair of patterns; if costs grow with distance (ConnectionCost::ends), O(n log n), from a
/// grid.
#pragma once

#include <span>
#include <vector>

#include "algorithms/tour/tour_problem.hpp"

namespace oxturn {

struct Neighbour {
  double cost;        // the least over the patterns of the element
  ElementId element;  // another one than the pattern's own
  PatternId pattern;  // the one of this cost
};

class NeighbourLists {
 public:
  /// The k cheapest; where they are found by distance also the two nearest in each quadrant (Johnson and McGeoch 1997),
  /// without which clusters of points would have no neighbours outside. The cheapest first.
  NeighbourLists(const TourProblem& problem, std::size_t k);
  std::span<const Neighbour> after(PatternId p) const { return after_.of(p); }
  std::span<const Neighbour> before(PatternId p) const { return before_.of(p); }

 private:
  struct Lists {
    std::vector<Neighbour> all;
    std::vector<std::size_t> first{0};  // by pattern
    std::span<const Neighbour> of(PatternId p) const { return {all.data() + first[p], first[p + 1] - first[p]}; }
  };
  static Lists build(const TourProblem& problem, std::size_t k, bool after);

  Lists after_, before_;
};

}  // namespace oxturn
