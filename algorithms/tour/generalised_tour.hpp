/// An open generalised tour by the tour solver: the order of elements and the pattern of each, chosen together.
///
///   const TourCosts costs(start, elements, connector);
///   const std::vector<TourStop> tour = generalised_tour(costs, context);
///
/// For elements with many patterns that cost different amounts, such as a cell that can be driven in several
/// directions. Connections cost the length of the path inside configuration space. Only those that a tour uses are
/// searched: all others cost their straight distance until a tour uses them, as long as that changes the tour, at most
/// 40 times. Optimal up to about ten elements, which are solved exactly with all paths. Cost: see solve_tour.hpp, for
/// 5000 kicks and then 1000 a round.
#pragma once

#include "algorithms/tour/open_tour.hpp"

namespace oxturn {

/// From the start over all elements; ends anywhere. If cancelled, the best tour so far.
std::vector<TourStop> generalised_tour(const TourCosts& costs, Context& context);

/// What a tour costs: patterns and connections.
double cost_of(const TourCosts& costs, const std::vector<TourStop>& tour);

/// The patterns of an element that may be of use in some tour, ascending. Another pattern is dominated: driving to the
/// entry of a cheaper one, along it, and from its exit back costs less (Bähnemann et al. 2019).
/// `length(a, b)`: of the path from a to b.
template <class Length>
std::vector<std::size_t> undominated(const TourElement& element, Length length) {
  std::vector<std::size_t> kept;
  for (std::size_t a = 0; a < element.size(); ++a) {
    bool dominated = false;
    for (std::size_t b = 0; b < element.size() && !dominated; ++b) {
      const double saved = element[a].cost - element[b].cost;
      if (distance(element[a].entry, element[b].entry) + distance(element[b].exit, element[a].exit) >= saved) continue;
      dominated = length(element[a].entry, element[b].entry) + length(element[b].exit, element[a].exit) < saved;
    }
    if (!dominated) kept.push_back(a);
  }
  return kept;
}

}  // namespace oxturn
