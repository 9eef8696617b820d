#include <stdexcept>

#include "algorithms/tour/tour_start.hpp"

namespace oxturn {

Tour nearest_neighbour_tour(const TourProblem& problem) {
  std::vector<bool> visited(problem.elements(), false);
  const auto allowed = [&](ElementId e) {
    if (visited[e]) return false;
    for (const ElementId sooner : problem.before(e))
      if (!visited[sooner]) return false;
    return true;
  };
  PatternId at = problem.first_pattern(0);
  Tour tour{problem.stop_of(at)};
  visited[0] = true;
  while (tour.size() < problem.elements()) {
    PatternId best = kNoPattern;
    double least = 0;
    for (ElementId e = 1; e < problem.elements(); ++e) {
      if (!allowed(e)) continue;
      for (PatternId q = problem.first_pattern(e); q < problem.end_pattern(e); ++q)
        if (const double cost = problem.connection(at, q); best == kNoPattern || cost < least) {
          best = q;
          least = cost;
        }
    }
    if (best == kNoPattern)
      throw std::invalid_argument(
          "elements of a tour are required before each other in a cycle; remove one requirement");
    at = best;
    visited[problem.element_of(at)] = true;
    tour.push_back(problem.stop_of(at));
  }
  return tour;
}

}  // namespace oxturn
