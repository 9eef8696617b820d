#include <algorithm>
#include <limits>

#include "algorithms/tour/assignment.hpp"
#include "algorithms/tour/tour_start.hpp"

namespace oxturn {
namespace {

using Cycle = std::vector<ElementId>;

std::vector<Cycle> cycles_of(const std::vector<std::size_t>& next) {
  std::vector<Cycle> cycles;
  std::vector<bool> seen(next.size(), false);
  for (std::size_t i = 0; i < next.size(); ++i) {
    if (seen[i]) continue;
    cycles.emplace_back();
    for (std::size_t j = i; !seen[j]; j = next[j]) {
      seen[j] = true;
      cycles.back().push_back(static_cast<ElementId>(j));
    }
  }
  return cycles;
}

/// Puts `cycle` into `tour` where exchanging the ends of two connections, one of each, costs least.
void patch(const TourProblem& problem, Cycle& tour, const Cycle& cycle) {
  const std::size_t n = tour.size(), m = cycle.size();
  double least = std::numeric_limits<double>::infinity();
  std::size_t at = 0, turn = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) {
      const ElementId a = tour[i], b = tour[(i + 1) % n], c = cycle[j], d = cycle[(j + 1) % m];
      const double removed = problem.connection(a, b) + (m > 1 ? problem.connection(c, d) : 0.0);
      const double cost = problem.connection(a, d) + problem.connection(c, b) - removed;
      if (cost >= least) continue;
      least = cost;
      at = i + 1;
      turn = (j + 1) % m;
    }
  Cycle turned = cycle;
  std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(turn), turned.end());
  tour.insert(tour.begin() + static_cast<std::ptrdiff_t>(at), turned.begin(), turned.end());
}

}  // namespace

Tour patched_assignment_tour(const TourProblem& problem) {
  const Assignment assignment = solve_assignment(problem.elements(), [&](std::size_t i, std::size_t j) {
    return i == j ? kForbidden : problem.connection(static_cast<PatternId>(i), static_cast<PatternId>(j));
  });
  std::vector<Cycle> cycles = cycles_of(assignment.column);
  std::stable_sort(cycles.begin(), cycles.end(), [](const Cycle& a, const Cycle& b) { return a.size() > b.size(); });
  Cycle order = cycles.front();
  for (std::size_t k = 1; k < cycles.size(); ++k) patch(problem, order, cycles[k]);
  std::rotate(order.begin(), std::find(order.begin(), order.end(), 0), order.end());
  Tour tour;
  for (const ElementId e : order) tour.push_back({e, 0});
  return tour;
}

}  // namespace oxturn
