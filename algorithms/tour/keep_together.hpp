/// Costs under which each group of elements is driven without others in between: clustered tours.
///
///   const KeepTogether cost(straight, {kNoGroup, 0, 0, 1, 1, 1});    // the group of each pattern
///   TourProblem problem(cost, 6);
///   const Tour tour = solve_tour(problem, context);                 // price it with `straight`
///
/// Connections between groups cost more than any tour, so the cheapest tour has as few of them as can be: one for each
/// group (Chisman 1975). The parts of one area, or the letters of one word, are finished before the robot goes on.
/// Asks for all costs once: O(n^2).
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/tour/connection_cost.hpp"

namespace oxturn {

/// An element that is a group of its own.
inline constexpr std::size_t kNoGroup = static_cast<std::size_t>(-1);

class KeepTogether final : public ConnectionCost {
 public:
  /// `groups`: of each pattern; the same for all patterns of an element. Keeps a reference to `cost`. Throws
  /// std::invalid_argument if the costs are too large for exact sums.
  KeepTogether(const ConnectionCost& cost, std::vector<std::size_t> groups);
  double operator()(PatternId from, PatternId to) const override;
  bool symmetric(const std::vector<PatternId>& reverse) const override { return cost_.symmetric(reverse); }
  /// What a connection between groups costs more.
  double penalty() const { return penalty_; }

 private:
  const ConnectionCost& cost_;
  std::vector<std::size_t> groups_;
  double penalty_ = 0;
};

}  // namespace oxturn
