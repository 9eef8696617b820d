#include "algorithms/tour/pattern_choice.hpp"

#include <limits>

namespace oxturn {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// Shortest paths from one pattern of the first layer through all layers and back to it.
class Layers {
 public:
  Layers(const TourProblem& problem, const Tour& tour) : problem_(problem), tour_(tour), before_(tour.size()) {}

  /// The least cost; the patterns are in `chosen`.
  double solve(PatternId root, std::vector<PatternId>& chosen) {
    std::vector<double> cost{problem_.inner(root)}, next;
    PatternId first = root, end = root + 1;  // patterns of the layer reached
    for (std::size_t i = 1; i < tour_.size(); ++i) {
      const auto e = static_cast<ElementId>(tour_[i].element);
      next.assign(problem_.pattern_count(e), kNone);
      before_[i].assign(next.size(), first);
      for (PatternId q = problem_.first_pattern(e); q < problem_.end_pattern(e); ++q)
        for (PatternId p = first; p < end; ++p)
          relax(cost[p - first] + problem_.connection(p, q) + problem_.inner(q), p, next[q - problem_.first_pattern(e)],
                before_[i][q - problem_.first_pattern(e)]);
      first = problem_.first_pattern(e);
      end = problem_.end_pattern(e);
      cost.swap(next);
    }
    double least = kNone;
    PatternId last = first;
    for (PatternId p = first; p < end; ++p) relax(cost[p - first] + problem_.connection(p, root), p, least, last);
    for (std::size_t i = tour_.size(); i-- > 0;) {
      chosen[i] = last;
      if (i > 0) last = before_[i][last - problem_.first_pattern(static_cast<ElementId>(tour_[i].element))];
    }
    return least;
  }

 private:
  static void relax(double cost, PatternId p, double& least, PatternId& from) {
    if (cost >= least) return;
    least = cost;
    from = p;
  }

  const TourProblem& problem_;
  const Tour& tour_;
  std::vector<std::vector<PatternId>> before_;  // [layer][pattern]: pattern of the layer before
};

}  // namespace

Tour best_patterns(const TourProblem& problem, const Tour& tour) {
  if (tour.size() < 2) return tour;
  Tour best = tour;
  double least = problem.cost(tour);
  Layers layers(problem, tour);
  std::vector<PatternId> chosen(tour.size());
  const auto root = static_cast<ElementId>(tour.front().element);
  const PatternId given = problem.pattern_of(tour.front());
  for (PatternId p = problem.first_pattern(root); p < problem.end_pattern(root); ++p) {
    if (problem.has_direction() && p != given) continue;
    const double cost = layers.solve(p, chosen);
    if (cost >= least) continue;
    least = cost;
    for (std::size_t i = 0; i < tour.size(); ++i) best[i] = problem.stop_of(chosen[i]);
  }
  return best;
}

}  // namespace oxturn
